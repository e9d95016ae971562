#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/longest_runs.h"
#include "core/engines/horizon/counting/run_doubts.h"
#include "core/engines/horizon/counting/run_rays.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Uses rays to decide the longest runs that horizons leave in doubt (run_doubts.h) and, if runs are checked,
/// to correct those that turn out to be lit somewhere. For the receivers of one tile.
class RunDecider {
public:
    /// All arguments must outlive it.
    RunDecider(const RunDoubts& doubts, RunRays& rays, const ReceiverBlocks& blocks)
        : doubts_(doubts), rays_(rays), blocks_(blocks) {}

    /// Working memory, one per thread.
    struct Memory {
        RunDoubts::Horizons widened;
        RunSearch search;
    };
    /// Corrects the result of `runs` for the numbers [64 part, 64 part + 64). Bit k of `lanes`: lane k is to
    /// be examined. Afterwards runs are off by at most doubts.allowed() steps, except for gaps that no bin
    /// sees. Costs as much as finding the runs, plus some rays for each run in doubt.
    void decide(const LongestRuns& runs, std::span<const RunLanes> horizons, std::size_t part,
                std::uint64_t lanes, LongestRuns::Found& found, Memory& memory) const;

private:
    [[nodiscard]] bool holds(const LongestRuns& runs, std::span<const RunLanes> horizons, std::size_t lane,
                             const LongestRuns::Found& found, const RunSearch::Rays& rays) const;

    const RunDoubts& doubts_;
    RunRays& rays_;
    const ReceiverBlocks& blocks_;
};

}  // namespace noonmark
