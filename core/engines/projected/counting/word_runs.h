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

/// The words of the same 64 cells, one for each group of eight steps.
using WordSteps = std::span<const StepWords* const>;

/// Counts all cells of a word, by lanes or by changes, whichever is faster on this processor. `words`: one
/// per group of eight steps; steps after the first `steps` are ignored. Both ways give the same runs.
void countRuns(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs);

/// Step by step, with one 16-bit lane per cell, for periods of up to `maxStepsInLanes` steps: 1 ns per step
/// with registers of 64 bytes, 4 ns with registers of 32 bytes.
void countByLanes(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs);
inline constexpr std::size_t maxStepsInLanes = 65'535;

/// 1 ns per step, and some ns for each cell that goes into or out of shadow.
void countByChanges(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs);

}  // namespace noonmark
