#pragma once

#include <cstddef>
#include <string>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// What of a study lies beyond the terrain, where its nearest elevation stands in for the ground: farther out
/// than half a cell from the outer posts. All zero without terrain.
struct TerrainCoverage {
    struct Share {
        std::size_t all = 0, off = 0;
        std::size_t farOff = 0;  ///< of these, farther from the terrain than its shorter side
        double farthestM = 0;
        bool operator==(const Share&) const = default;
    };
    Share receivers;
    Share casters;  ///< buildings whose shadow can reach the region, by the middle of their box
    bool operator==(const TerrainCoverage&) const = default;
};

/// Receivers are cells; the region's own where `receivers` lists none (tiles), at most some 10^6 of them
/// spread evenly. O(cells): some 0.1 us each, less where the whole region lies on the terrain.
TerrainCoverage terrainCoverage(const City& city, const Receivers& receivers, const SunSteps& sun);
TerrainCoverage terrainCoverage(const City& city, const Region& region, const Grid& cells,
                                const SunSteps& sun);

/// Error: more than half of the receivers lie beyond the terrain, or more than half of the buildings in reach
/// farther from it than its shorter side. `region`: its name.
Result<void> checkCoverage(const TerrainCoverage& coverage, const std::string& region);

/// What a result has to state of it.
Warnings warningsOf(const TerrainCoverage& coverage);

}  // namespace noonmark
