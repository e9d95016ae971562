#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/inverse/lane_receivers.h"
#include "core/engines/inverse/shadow_lines.h"
#include "core/engines/inverse/sources/source_finder.h"

namespace noonmark {

/// Some steps of an interval, with what throws the shadows at their ends and how these move in between.
struct LineLeg {
    const SourceInstant& atFirst;
    const SourceInstant& atLast;
    SunInterval interval;
    int firstStep;  ///< of the leg, in the masks
    LinePass forward, backward;

    LineLeg(const Lanes& lanes, const SourceInstant& first, const SourceInstant& last,
            const SunInterval& interval, int firstStep);
};

/// Memory for some blocks of lanes, used again block after block.
struct BlockWork {
    LaneSources first, last;
    LaneMasks masks;
    std::vector<std::vector<Line<std::uint32_t>>> numbers;  ///< of receivers, a block each
};

/// Draws legs, all over the same lanes.
class LegDrawer {
public:
    /// All outlive it.
    LegDrawer(const Lanes& lanes, const LaneReceivers& receivers, ShadowLineDrawer& drawer, int levels)
        : lanes_(lanes), receivers_(receivers), drawer_(drawer), levels_(levels) {}

    /// Where most receivers of a block have a full list at both ends, what lies behind may matter in between:
    /// those blocks, ascending. Else the bits of the leg's steps are the receivers' shadow; earlier steps
    /// stay, later ones are cleared. All cores.
    Result<std::vector<int>> draw(const LineLeg& leg, std::span<const int> blocks,
                                  std::span<ShadowMask> masks, const std::stop_token& stop) const;

    /// Those of the blocks where more than so large a share of the receivers lies in a shadow of the instant
    /// at which their masks, bit `step`, have none. One receiver in four is asked. All cores.
    [[nodiscard]] std::vector<int> missing(const SourceInstant& instant, int step, double mostMissed,
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
