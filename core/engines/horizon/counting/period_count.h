#pragma once

// From horizons to minutes. PeriodCount (this file) holds what is precomputed for a period; sun_change.h
// looks up how many suns a horizon hides, or how many more than in another period. short_sums.h sums the
// hidden steps of a tile's cells. longest_runs.h finds the longest run of each receiver, step by step
// (walk_steps.h). run_decider.h finds which of these steps are in doubt, and longest_runs.h decides them
// with rays.

#include <algorithm>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/horizon/counting/longest_runs.h"
#include "core/engines/horizon/counting/run_decider.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/overhangs/overhang_intervals.h"

namespace noonmark {

/// Codes of a tile, one per number, for each bin of a period.
using BinCodes = std::vector<std::span<const HorizonCode>>;
/// Gaps hidden by overhangs above the horizons, for each bin.
using BinGaps = std::vector<std::span<const Gap>>;

/// A gap that does not begin at the horizon; its number is a lane.
struct OverhangGap {
    std::uint16_t bin;
    Gap gap;
};

/// The gaps of one lane by bin.
using GapsByBin = std::vector<std::span<const OverhangGap>>;
/// `own`: of one lane, sorted by bin. Reuses the memory of `ofBin`.
void listByBin(std::span<const OverhangGap> own, std::size_t bins, GapsByBin& ofBin);

inline bool isInGap(std::span<const OverhangGap> gaps, HorizonCode sun) {
    return std::ranges::any_of(
        gaps, [&](const OverhangGap& one) { return one.gap.low <= sun && sun < one.gap.high; });
}

/// Calls visit(lane, own) with the gaps of each lane that has any. `overhangs`: sorted by lane.
template <class Visit>
void forEachLane(std::span<const OverhangGap> overhangs, const Visit& visit) {
    for (std::size_t first = 0, end = 0; first < overhangs.size(); first = end) {
        while (end < overhangs.size() && overhangs[end].gap.number == overhangs[first].gap.number) ++end;
        visit(overhangs[first].gap.number, overhangs.subspan(first, end - first));
    }
}

/// Working memory for counting runs; one per thread.
struct RunMemory {
    std::vector<RunLanes> lanes, filled;  // one per bin; `filled` only if there are overhangs
    std::vector<OverhangGap> overhangs;   // sorted by lane once the runs are found
    RunLanes undecided;                   ///< longest runs of the part as horizons have them, before rays
    GapsByBin gaps;                       ///< of a lane
    RunDecider::Memory deciding;
};

/// Counts the longest runs of a period from horizons. Immutable.
class RunCount {
public:
    explicit RunCount(std::vector<TimedStep> steps) : runs_(std::move(steps)) {}

    [[nodiscard]] std::span<const TimedStep> steps() const { return runs_.steps(); }

    /// Longest runs of the numbers [64 part, 64 part + 64), in steps. `gaps`: for each bin, sorted by number
    /// and altitude; may be empty. Where gaps matter, each receiver is walked step by step: 0.3 ms for a year
    /// of minutes.
    [[nodiscard]] RunLanes longestRuns(const BinCodes& codes, const BinGaps& gaps, std::size_t part,
                                       RunMemory& memory) const;

    /// The same, with runs in doubt decided by rays through `decider`. Bit k of `lanes`: lane k is a
    /// receiver.
    [[nodiscard]] RunLanes decidedRuns(const BinCodes& codes, const BinGaps& gaps, std::size_t part,
                                       const RunDecider& decider, std::uint64_t lanes,
                                       RunMemory& memory) const;

private:
    static void read(const BinCodes& codes, const BinGaps& gaps, std::size_t part, RunMemory& memory);
    PartRuns find(RunMemory& memory) const;
    void walkWithOverhangs(RunMemory& memory, PartRuns& runs) const;

    LongestRuns runs_;
};

/// A period prepared for counting from horizons. Immutable.
class PeriodCount {
public:
    PeriodCount(const SunSteps& sun, const BinnedSun& binned, ShadowCounts counts);

    /// The suns of a bin, for looking up many horizons.
    [[nodiscard]] std::span<const CountChange> suns(std::size_t bin) const { return suns_[bin]; }

    /// Null if runs are not wanted.
    [[nodiscard]] const RunCount* runs() const { return runs_ ? &*runs_ : nullptr; }

private:
    std::optional<RunCount> runs_;
    std::vector<std::vector<CountChange>> suns_;
};

/// Bit k: the number 64 part + k is a receiver.
std::uint64_t findReceiverLanes(const ReceiverBlocks& blocks, std::size_t part);

/// Writes the minutes of numbers [64 part, 64 part + 64) to their cells. `hidden`: steps, one per number.
void writeGross(const ReceiverBlocks& blocks, std::size_t part, std::span<const std::uint32_t> hidden,
                ShadowField& field);
void writeRuns(const ReceiverBlocks& blocks, std::size_t part, const RunLanes& longest, ShadowField& field);

/// Number of parts of 64 numbers.
inline std::size_t partsOf(const ReceiverBlocks& blocks) {
    return (blocks.numbers() + lanesPerPart - 1) / lanesPerPart;
}

}  // namespace noonmark
