#pragma once

#include <chrono>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/sun/civil_time.h"

namespace noonmark {

/// A date and a time of day, in the time zone of the study.
struct ViewMoment {
    CivilDate date{};
    std::chrono::minutes at{0};  ///< since midnight, 0 to 24 h
    bool operator==(const ViewMoment&) const = default;
};

/// What a view shows of the city: a box along east, north and up, local metres.
struct ViewBox {
    glm::dvec3 lowM{0};   ///< west, south, bottom
    glm::dvec3 highM{0};  ///< east, north, top; each above lowM
    bool operator==(const ViewBox&) const = default;
};

/// Whether each side is above 0 and lies within 1e7 m.
bool isBox(const ViewBox& box);

/// A view of the city under a name: camera, projection, moment and section box.
struct SavedView {
    std::string name;                    ///< unique in a project
    glm::dvec3 targetM{0};               ///< point that the camera looks at, local metres
    double distanceM = 1000;             ///< from the eye to the target, above 0
    double headingDeg = 0;               ///< clockwise from true north, 0 to 360
    double pitchDeg = 45;                ///< below the horizontal, 0 to 90
    bool parallel = false;               ///< parallel (orthographic) projection, not perspective
    std::optional<ViewMoment> moment{};  ///< none: the view shows the whole period
    std::optional<ViewBox> section{};    ///< none: the view shows the whole city
    bool operator==(const SavedView&) const = default;
};

/// Error: a number out of range.
Result<void> validate(const SavedView& view);

}  // namespace noonmark
