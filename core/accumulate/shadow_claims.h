#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/shadow_lines.h"

namespace noonmark {

/// What throws the shadows of an interval: sources at its first step and at its last.
struct IntervalSources {
    const ShadowSources& atFirst;
    const ShadowSources& atLast;
    const SunInterval& interval;
};

/// Adds to cellSteps[building], for the wanted cells of the grid, the steps at which that building is the
/// first thing on the way to the sun: of the lines that shade a cell at a step, the lowest source's has it.
/// Each shaded cell-step, as ShadowLineDrawer draws them, goes to one building. `wanted`: grid order. All
/// cores, some 30 ns a shaded cell-step; incomplete after a stop request. Steps before `fromStep` don't
/// count.
void claimSteps(const Grid& grid, const IntervalSources& sources, int fromStep,
                const std::vector<bool>& wanted, std::span<std::uint64_t> cellSteps,
                const std::stop_token& stop);

}  // namespace noonmark
