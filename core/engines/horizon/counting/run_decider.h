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

/// What the horizons of a part say, and the runs that they give.
struct PartRuns {
    std::span<const RunLanes> horizons, filled;  ///< as RunDoubts::widen() takes them; one entry per bin
    LongestRuns::Found found;
    std::array<StepRun, lanesPerPart> below{};  ///< runs of lanes below overhangs; empty: that of `found`
};

/// Uses rays to confirm longest runs where horizons leave their steps in doubt (run_doubts.h), and to search
/// those that are not confirmed or may be longer. For the receivers of one tile.
class RunDecider {
public:
    /// All arguments must outlive it.
    RunDecider(const RunDoubts& doubts, RunRays& rays, const ReceiverBlocks& blocks)
        : doubts_(doubts), rays_(rays), blocks_(blocks) {}

    /// Working memory, one per thread.
    struct Memory {
        RunDoubts::Horizons widened;
        std::vector<RunLanes> most;  // one per day
        std::vector<std::uint32_t> steps;
        RunSearch search;
    };
    /// Corrects the runs of the numbers [64 part, 64 part + 64). Bit k of `lanes`: lane k is to be examined.
    /// Afterwards runs are off by at most RunDoubts::allowed steps, as far as doubts are known. Costs as much
    /// as finding the runs, and some rays for each run.
    void decide(const LongestRuns& runs, std::size_t part, std::uint64_t lanes, PartRuns& of,
                Memory& memory) const;

private:
    void doubtOpen(std::size_t part, std::uint64_t lanes, Memory& memory) const;
    [[nodiscard]] bool holds(const LongestRuns& runs, std::size_t lane, const PartRuns& of,
                             const RunRays::Receiver& rays, Memory& memory) const;

    const RunDoubts& doubts_;
    RunRays& rays_;
    const ReceiverBlocks& blocks_;
};

}  // namespace noonmark
