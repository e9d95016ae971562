#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/engines/projected/counting/run_starts.h"
#include "core/engines/projected/filling/step_lanes.h"

namespace noonmark {

/// Shadow of the 64 cells of a word over a period, in steps.
struct alignas(64) WordRuns {
    std::uint32_t gross[64];
    std::uint32_t longest[64];
};

/// Counts all cells of a word, step by step. `words`: one per group of eight steps; steps after the first
/// `steps` are ignored. Some 1 ns per step if the processor has suitable 16-bit lanes and the period fits
/// them; otherwise some ns for each cell that goes into or out of shadow.
void countRuns(std::span<const StepWords* const> words, std::span<const RunStarts> starts, std::size_t steps,
               WordRuns& runs);

}  // namespace noonmark
