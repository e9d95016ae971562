#pragma once

#include <QString>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// How the shadow of what is being shaped is worked out.
enum class LiveEngine {
    shadows,   ///< each building's polygons at every step stay (shadow_cache.h): exact, level ground only
    horizons,  ///< horizons stay (shared_horizon_cache.h): every step of any period, wherever; off by up to
               ///< half a bin of azimuth
    moments,  ///< as shadows, of some moments spread over the period: exact at these only
};

struct LiveRule {
    /// Up to so many steps each has its polygons: twelve hours by the minute.
    static constexpr std::size_t mostSteps = 720;
    /// So many of a longer period, where it comes to that: far apart, each costs more.
    static constexpr std::size_t someMoments = 120;
    /// A region of more cells is too slow to follow and does not fit into the kept horizons' memory for a
    /// year: a square around the shape is shown in its place.
    static constexpr std::size_t mostCells = std::size_t{1} << 20U;
};

/// The engines for a city, receivers and number of steps, the best first; where one refuses (too much hangs,
/// too little memory) the next is tried. Polygons where they are exact; else horizons; moments only where
/// horizons cannot be kept, on level ground.
std::vector<LiveEngine> liveEngines(const City& city, ReceiverPlaces places, std::size_t steps);

/// Beside the legend: what is shown and how exact it is. `counted` of `steps` steps; `runs`: the longest ones
/// are there, too.
QString describeLive(LiveEngine engine, std::size_t counted, std::size_t steps, bool runs);

}  // namespace noonmark
