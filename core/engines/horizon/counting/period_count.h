#pragma once

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
#include "core/engines/horizon/overhangs/gaps.h"

namespace noonmark {

/// Codes of a tile, one a number, for each bin of a period.
using BinCodes = std::vector<std::span<const HorizonCode>>;
/// What hangs above them.
using BinGaps = std::vector<std::span<const Gap>>;

/// A gap that does not begin at the horizon; its number is a lane.
struct OverhangGap {
    std::uint16_t bin;
    Gap gap;
};

/// Memory to count runs in; one for each thread.
struct RunMemory {
    std::vector<RunLanes> lanes;  // of each bin
    std::vector<OverhangGap> overhangs;
    RunDecider::Memory deciding;
};

/// The longest runs of a period from horizons. Immutable.
class RunCount {
public:
    RunCount(std::vector<TimedStep> steps, std::span<const DaySteps> days) : runs_(std::move(steps), days) {}

    [[nodiscard]] std::size_t steps() const { return runs_.steps().size(); }

    /// Of the numbers [64 part, 64 part + 64), in steps. `gaps`: of each bin, by number and from below; or
    /// none. Where gaps matter each receiver is walked step by step, 0.3 ms for a year of minutes.
    [[nodiscard]] RunLanes longestRuns(const BinCodes& codes, const BinGaps& gaps, std::size_t part,
                                       RunMemory& memory) const;

    /// The same, decided by rays where `decider` says so. Bit k of `lanes`: lane k is a receiver. Where gaps
    /// matter rays are not asked.
    [[nodiscard]] RunLanes decidedRuns(const BinCodes& codes, const BinGaps& gaps, std::size_t part,
                                       const RunDecider& decider, std::uint64_t lanes,
                                       RunMemory& memory) const;

private:
    static void read(const BinCodes& codes, const BinGaps& gaps, std::size_t part, RunMemory& memory);
    void walkWithOverhangs(RunMemory& memory, RunLanes& longest) const;

    LongestRuns runs_;
};

/// A period ready to be counted from horizons. Immutable.
class PeriodCount {
public:
    /// What is asked for besides the suns of each bin.
    struct Wanted {
        bool gaps = false, runs = true;
    };
    PeriodCount(const SunSteps& sun, const BinnedSun& binned, const Wanted& wanted);

    /// The suns of a bin, to look up many horizons.
    [[nodiscard]] std::span<const SunChange> suns(std::size_t bin) const { return suns_[bin]; }
    /// The same, to look up one; only where gaps are asked for.
    [[nodiscard]] const HiddenSuns& hidden(std::size_t bin) const { return hidden_[bin]; }

    /// Null where they are not wanted.
    [[nodiscard]] const RunCount* runs() const { return runs_ ? &*runs_ : nullptr; }

private:
    std::optional<RunCount> runs_;
    std::vector<std::vector<SunChange>> suns_;
    std::vector<HiddenSuns> hidden_;
};

/// Bit k: the number 64 part + k is a receiver.
std::uint64_t findReceiverLanes(const ReceiverBlocks& blocks, std::size_t part);

/// Writes minutes of numbers [64 part, 64 part + 64) into their cells. `hidden`: steps, one a number.
void writeGross(const ReceiverBlocks& blocks, std::size_t part, std::span<const std::uint32_t> hidden,
                ShadowField& field);
void writeRuns(const ReceiverBlocks& blocks, std::size_t part, const RunLanes& longest, ShadowField& field);

/// Parts of 64 numbers.
inline std::size_t partsOf(const ReceiverBlocks& blocks) {
    return (blocks.numbers() + lanesPerPart - 1) / lanesPerPart;
}

}  // namespace noonmark
