#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/geo/grid.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// A line along which a field has one value, local metres.
struct Isochrone {
    double level = 0;  ///< minutes, or the unit of the values
    /// The first point is not repeated in a closed line.
    std::vector<glm::vec2> points;
    /// A ring: shadow of this length all inside or all outside it. An open line ends at the grid's edge or at
    /// cells without a value.
    bool closed = false;
};

/// Lines of equal values: between the centres of the grid's cells values are interpolated, so a line is exact
/// to a cell. Islands and holes are rings of their own. `values`: one a cell in grid order (row 0 south), NaN
/// where there is none; where a value equals a level, the line passes just below it. In the order of the
/// levels. O(cells x levels). Empty where memory runs out or `values` has another size. Backend:
/// day_isochrones_gdal.cpp.
std::vector<Isochrone> traceIsochrones(const Grid& grid, std::span<const float> values,
                                       std::span<const double> levels);

struct IsochroneSettings {
    Box2 area;                      ///< local metres
    std::vector<double> levelsMin;  ///< minutes in shadow; ascending
    std::optional<double> planeM;   ///< of a plane above the mean ground; none: on the ground
};

struct DayIsochrones {
    double cellM = 1;  ///< the lines are exact to a cell
    std::vector<Isochrone> lines;
    std::string engine;  ///< name and settings, as text
};

/// Lines of equal minutes in shadow of a city on one day (all of `day`), on cells of 0.5 to 10 m of which the
/// area has no more than some 600,000 (90,000 where rays measure). Places under buildings count as ground:
/// Japan's lines run through the neighbours' houses. The engine that AutoEngine chooses measures, but rays on
/// a plane above terrain or above a city with meshes. Errors of Engine::accumulate(); cancelled().
Result<DayIsochrones> traceDayIsochrones(const City& city, const SunSteps& day,
                                         const IsochroneSettings& settings, Progress& progress,
                                         const std::stop_token& stop);

}  // namespace noonmark
