#pragma once

#include <array>
#include <chrono>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/sun/civil_time.h"
#include "core/sun/solar_position.h"

namespace noonmark {

/// Where and when the sun's paths are asked for.
struct SunPathQuestion {
    Observer observer;
    std::string zone = "UTC";  ///< IANA name; days begin at its midnight
    std::chrono::year year{2026};
    /// Local time minus UTC of the clock that the hour lines show, the same all year: where clocks change, a
    /// line of the wall clock would be broken in two.
    std::chrono::seconds clockOffset{0};
    bool refraction = true;  ///< true: the apparent sun; false: the geometric sun
    bool operator==(const SunPathQuestion&) const = default;
};

/// A line on the sky above the horizon: unit vectors in the frame of the geometry, in the order of time.
struct SunCurve {
    std::vector<glm::dvec3> towards;
    bool closed = false;  ///< the sun does not set: the last direction is followed by the first
};

/// The lines of a sun path diagram. A line that the horizon cuts is several curves; one below it has none.
struct SunPaths {
    std::array<std::vector<SunCurve>, 12> months;  ///< path of the 21st of each month, January first
    /// The sun at each full hour of the clock, 0 to 23, through the year: a figure of eight (analemma).
    std::array<std::vector<SunCurve>, 24> hours;
};

/// Directions are 10 minutes apart on paths, 5 days on hour lines; ends at the horizon are interpolated, off
/// by up to half a degree. Error: an unknown zone, an observer out of range, a year outside 1900 to 2100.
/// About 7 ms.
Result<SunPaths> computeSunPaths(const SunPathQuestion& question);

/// The path of one day, of any year in the range. About 0.2 ms.
Result<std::vector<SunCurve>> computeSunPath(const SunPathQuestion& question, CivilDate date);

}  // namespace noonmark
