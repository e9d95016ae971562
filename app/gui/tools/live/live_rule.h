#pragma once

#include <QString>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The method of the live shadow.
enum class LiveEngine {
    /// The projected polygons of each building at every step are cached (shadow_cache.h): exact, on level
    /// ground only.
    shadows,
    /// Horizons are cached (shared_horizon_cache.h): any period, any receivers; the azimuth is off by up to
    /// half a bin.
    horizons,
    /// As `shadows`, at some moments spread over the period: exact at these only.
    moments,
};

struct LiveRule {
    /// Up to this many steps, polygons of each step are cached: twelve hours minute by minute.
    static constexpr std::size_t maxSteps = 720;
    /// Number of moments of a longer period. Fewer than maxSteps, since moments far apart cost more each.
    static constexpr std::size_t someMoments = 120;
    /// A region with more cells is too slow to follow, and the horizons of a year would not fit into the
    /// cache: a square around the shape is used instead.
    static constexpr std::size_t maxCells = std::size_t{1} << 20U;
};

/// The methods for a city, receivers and number of steps, the best first; if one refuses (too many overhangs,
/// too little memory) the next is tried. Polygons where they are exact, else horizons; moments only on level
/// ground and if horizons cannot be cached.
std::vector<LiveEngine> liveEngines(const City& city, ReceiverPlaces places, std::size_t steps);

/// How exact a live shadow is, for the note beside the legend. `counted` of `steps` steps are computed;
/// `runs`: continuous shadow is included.
QString describeExactness(LiveEngine engine, std::size_t counted, std::size_t steps, bool runs);

}  // namespace noonmark
