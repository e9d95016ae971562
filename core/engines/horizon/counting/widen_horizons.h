#pragma once

#include <limits>

#include "core/engines/horizon/counting/walk_steps.h"

namespace noonmark {

/// Horizons of 64 receivers at the mean of a bin, and at those of its neighbours.
struct HorizonsBeside {
    const RunLanes &before, &own, &after;
};

/// Shares of the tangents before and after a bin in that of an edge which runs through all three.
struct EdgeShares {
    float before = 0, after = 0;  ///< both 0: never on one edge
};

/// The highest of the three.
void findHighest(const HorizonsBeside& of, RunLanes& highest);

/// Bounds where the three do not lie on one edge, within the rounding of codes: `lowest` is noHorizon there,
/// and else the lowest of the three; `highest`, unless null, becomes everyHorizon there, and else stays.
void boundOffEdge(const HorizonsBeside& of, const EdgeShares& shares, RunLanes& lowest, RunLanes* highest);
inline constexpr HorizonCode everyHorizon = std::numeric_limits<HorizonCode>::max();  ///< hides every sun

}  // namespace noonmark
