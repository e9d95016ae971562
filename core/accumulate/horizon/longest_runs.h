#pragma once

#include <cstdint>
#include <span>

#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

/// Receivers that are counted together.
inline constexpr std::size_t receiversABlock = 64;

/// Numbers of hidden steps of one bin, one a receiver.
struct alignas(64) BlockRanks {
    std::int16_t values[receiversABlock] = {};
};

/// A sum of ranks for each receiver of a block.
struct alignas(64) BlockSums {
    std::int32_t values[receiversABlock] = {};
};

/// The steps that each receiver spends in shadow. `ranks`: one a bin.
BlockSums sumsOf(std::span<const BlockRanks> ranks);

/// A step of the period, in time order.
struct TimedStep {
    StepPlace place;
    bool startsRun = false;  ///< a new day, or steps are missing before it
};

/// The longest unbroken run in shadow of each receiver of a block, in steps: every step of every day is
/// looked at. `ranks`: one a bin. No day may have more than 32,767 steps.
BlockRanks longestRuns(std::span<const BlockRanks> ranks, std::span<const TimedStep> steps);

}  // namespace noonmark
