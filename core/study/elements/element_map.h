#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/geo/frame.h"
#include "core/study/elements/element_study.h"

namespace noonmark {

/// The azimuth that a surface faces, from true north, clockwise, 0 to 360 degrees; NaN for a level surface.
/// `normal`: in the local frame.
inline double facingAzimuthDeg(const Frame& frame, LonLat place, glm::vec3 normal) {
    const glm::dvec2 level(normal);
    if (std::hypot(level.x, level.y) < 1e-3) return std::nan("");
    const glm::dvec2 eastNorth = glm::inverse(frame.localFromEastNorth(place)) * level;
    const double azimuth = Radians{std::atan2(eastNorth.x, eastNorth.y)}.degrees().value;
    return azimuth < 0 ? azimuth + 360 : azimuth;
}

/// The minutes of one point.
struct ElementMinutes {
    double sunlitMin = 0, grossMin = 0;           ///< a day, mean over the days
    double continuousMin = 0, longestSunMin = 0;  ///< the longest unbroken shadow and sun on any day
    std::array<double, 12> monthMin{};  ///< sun by month, minutes in all; NaN outside the period's months
};

/// The same with trees, as ShadedPoints.
struct ShadedMinutes : ElementMinutes {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
};

/// What was measured at one point, with the building that it belongs to.
struct MeasuredElement : ElementMinutes {
    std::string id;
    ElementKind kind = ElementKind::facade;
    std::string building, buildingName;  ///< id and name; empty: no building
    std::optional<std::int32_t> floor;   ///< of facades and windows
    double azimuthDeg = 0;               ///< that it faces, from true north; NaN where it faces up or down
    glm::vec3 position{0}, normal{0, 0, 1};  ///< local metres; a unit vector
    PaneSize pane;                           ///< the rectangle that it stands for
    std::vector<ShadedMinutes> withTrees;  ///< evergreens first; those of all points are of the same columns
};

/// The results of a study at points as a list, for tables, the view and the project.
struct ElementMap {
    std::vector<MeasuredElement> elements;
    double possibleMin = 0;  ///< minutes a day with the sun above the horizon, mean over the days
    std::optional<TreeColumns> column{};  ///< that it states of several (inColumn()), which legends name
};

/// The list with the minutes of one column in place of those without trees; nothing where it has no such
/// column.
std::optional<ElementMap> inColumn(const ElementMap& map, TreeColumns column);

/// A study at points with that list.
struct ElementAnswer {
    ElementStudy study;
    ElementMap map;
};

/// The corners of the rectangle that an element stands for, 3 cm in front of its wall, counterclockwise seen
/// from in front. A window that is a point has one of 1 x 1.2 m.
std::array<glm::vec3, 4> cornersOf(const MeasuredElement& element);

/// In the order of the study's receivers. Some 1 us a point.
ElementMap makeElementMap(const ElementStudy& study);

}  // namespace noonmark
