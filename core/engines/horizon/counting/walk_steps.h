#pragma once

#include <cstdint>
#include <span>

#include "core/engines/horizon/counting/timed_steps.h"

namespace noonmark {

/// Number of receivers that are counted together.
inline constexpr std::size_t lanesPerPart = 64;

/// Horizon codes of one bin, or counts of steps, one per receiver.
struct alignas(64) RunLanes {
    std::int16_t values[lanesPerPart] = {};
};

/// Walks the steps of a day: raises `longest` to the longest run of each lane, in steps. `horizons`: one
/// entry per bin. 1 ns a step with AVX-512.
void walkSteps(std::span<const RunLanes> horizons, std::span<const TimedStep> steps, RunLanes& longest);

}  // namespace noonmark
