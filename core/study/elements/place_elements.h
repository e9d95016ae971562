#pragma once

#include <array>
#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/elements/read_windows.h"
#include "core/receivers/point_receivers.h"
#include "core/study/study.h"

namespace noonmark {

/// Where the points of a study lie.
enum class ElementPlaces { facades, windows, plane };
/// "facades", "windows", "plane"
std::string_view nameOf(ElementPlaces places);
inline constexpr std::array allElementPlaces{ElementPlaces::facades, ElementPlaces::windows,
                                             ElementPlaces::plane};

struct ElementSettings {
    ElementPlaces places = ElementPlaces::facades;
    /// Facades: names or ids, in any case, one or several ("A,B") in a text; empty: all of the region.
    std::vector<std::string> buildings;
    FacadeSettings facades;         ///< its storeyM also numbers the floors of windows
    std::filesystem::path windows;  ///< file of the windows
    WindowFileSettings windowFile;
    double planeHeightM = 0;  ///< above the mean of the region's ground, 0 to mostPlaneHeightM
    bool operator==(const ElementSettings&) const = default;
};

/// The points of a study.
struct PlacedElements {
    PointReceivers receivers;
    std::vector<WindowFacts> facts;  ///< of the receivers; empty unless they are windows of a file
    double planeM = 0;               ///< local z of a plane
    Warnings warnings;               ///< from reading and placing
};

/// Places the points that the settings ask for, in the region and with the cells of `settings`. Error: a
/// setting out of range, a building that does not exist or lies outside the region, no points, what
/// readWindows() refuses, cancelled().
Result<PlacedElements> placeElements(const City& city, const StudySettings& settings,
                                     const ElementSettings& elements, Progress& progress,
                                     const std::stop_token& stop);

}  // namespace noonmark
