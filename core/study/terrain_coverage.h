#pragma once

#include <cstddef>
#include <string>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// How much of a study lies beyond the terrain, where the nearest elevation replaces the ground: more than
/// half a cell outside the outer posts. All zero without terrain.
struct TerrainCoverage {
    struct Share {
        std::size_t all = 0, off = 0;
        std::size_t farOff = 0;  ///< how many of them are farther from the terrain than its shorter side
        double farthestM = 0;
        bool operator==(const Share&) const = default;
    };
    Share receivers;
    Share casters;  ///< buildings whose shadow can reach the region, by the middle of their box
    bool operator==(const TerrainCoverage&) const = default;
};

/// Receivers are cells. The second form is for tiles: it takes the region's own cells, at most some 10^6 of
/// them, spread evenly. O(cells): some 0.1 us each, less if the whole region lies on the terrain.
TerrainCoverage computeTerrainCoverage(const City& city, const Receivers& receivers, const SunSteps& sun);
TerrainCoverage computeTerrainCoverage(const City& city, const Region& region, const Grid& cells,
                                       const SunSteps& sun);

/// Error: more than half of the receivers lie beyond the terrain, or more than half of the buildings in reach
/// are farther from it than its shorter side. `region`: its name.
Result<void> checkCoverage(const TerrainCoverage& coverage, const std::string& region);

/// Warnings that results have to state.
Warnings makeWarnings(const TerrainCoverage& coverage);

}  // namespace noonmark
