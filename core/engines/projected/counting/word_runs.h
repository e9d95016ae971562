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

/// Counts all cells of a word, step by step. `words`: of each eight steps; those beyond `steps` don't count.
/// Some 1 ns a step where the processor has lanes of 16 bits for it and they suffice; else some for each cell
/// that goes into or out of shadow.
void countRuns(std::span<const StepWords* const> words, std::span<const RunStarts> starts, std::size_t steps,
               WordRuns& runs);

}  // namespace noonmark
