#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/accumulate/low_sun.h"
#include "core/accumulate/shadow_lines.h"

namespace noonmark {

/// What throws the shadows of an interval on a block of lanes: sources at its first step and at its last.
struct IntervalLines {
    const LaneSources& atFirst;
    const LaneSources& atLast;
    const LinePass& forward;
    const LinePass& backward;
    const SunInterval& interval;
};

/// Adds to cellSteps[building], for the wanted places of block 0 of the lanes, the steps [fromStep, end) at
/// which that building is the first thing on the way to the sun: of the lines that shade a place at a step,
/// the lowest source's has it. Each shaded step of a place, as ShadowLineDrawer draws them, goes to one
/// building. `wanted`: majors x lanes of a block. One core, some 30 ns a shaded step of a place.
void claimSteps(const IntervalLines& lines, int fromStep, const std::vector<bool>& wanted,
                std::span<std::uint64_t> cellSteps);

}  // namespace noonmark
