#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/inverse/lane_receivers.h"
#include "core/engines/inverse/shadow_lines.h"
#include "core/engines/inverse/sources/source_finder.h"

namespace noonmark {

/// Some steps of an interval, with the shadow sources at both ends and the motion of the shadows in between.
struct LineLeg {
    const SourceInstant& atFirst;
    const SourceInstant& atLast;
    SunInterval interval;
    int firstStep;  ///< first step of the leg, in the masks
    LinePass forward, backward;

    LineLeg(const Lanes& lanes, const SourceInstant& first, const SourceInstant& last,
            const SunInterval& interval, int firstStep);
};

/// Working memory for some blocks of lanes, reused for the following blocks.
struct BlockWork {
    LaneSources first, last;
    LaneMasks masks;
    std::vector<std::vector<CacheLine<std::uint32_t>>> numbers;  ///< receiver numbers, one entry per block
};

/// Draws legs, all over the same lanes.
class LegDrawer {
public:
    /// All arguments must outlive it.
    LegDrawer(const Lanes& lanes, const LaneReceivers& receivers, ShadowLineDrawer& drawer, int levels)
        : lanes_(lanes), receivers_(receivers), drawer_(drawer), levels_(levels) {}

    /// Sets the bits of the leg's steps to the receivers' shadow; bits of earlier steps are kept, those of
    /// later steps are cleared. Returns the blocks, ascending, where most receivers have a full list at both
    /// ends, so that ignored occluders may matter in between. All cores.
    Result<std::vector<int>> draw(const LineLeg& leg, std::span<const int> blocks,
                                  std::span<ShadowMask> masks, const std::stop_token& stop) const;

    /// Returns those blocks in which more than the share `maxMissed` of the receivers are in shadow at the
    /// instant although their masks, bit `step`, are not. Checks one receiver in four. All cores.
    [[nodiscard]] std::vector<int> missing(const SourceInstant& instant, int step, double maxMissed,
                                           std::span<const int> blocks, std::span<const ShadowMask> masks,
                                           const std::stop_token& stop) const;

private:
    Result<void> drawBatch(const LineLeg& leg, std::span<const int> blocks, BlockWork& work) const;
    void prepare(const LineLeg& leg, int block, int slot, BlockWork& work) const;

    const Lanes& lanes_;
    const LaneReceivers& receivers_;
    ShadowLineDrawer& drawer_;
    int levels_;
};

}  // namespace noonmark
