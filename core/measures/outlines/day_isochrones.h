#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/measures/outlines/isochrones.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

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
