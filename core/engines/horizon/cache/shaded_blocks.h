#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/horizon/cache/occluder_cache.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"

namespace noonmark {

/// Marks blocks as visited. Reuses its memory.
class BlockMarks {
public:
    void begin(std::size_t blocks);
    /// Marks the block and returns whether it was not marked before.
    bool mark(std::size_t block) {
        const bool first = marks_[block] != turn_;
        marks_[block] = turn_;
        return first;
    }

private:
    std::vector<std::uint32_t> marks_;
    std::uint32_t turn_ = 0;
};

/// The area that some obstacles may shade, at one azimuth.
class ShadedBlocks {
public:
    /// `lowestTan`: of the bin's suns. `cellM`: metres per cell.
    void begin(const WallSet& set, const ShadowAxes& axes, double lowestTan, double cellM);

    /// Appends the blocks of a tile that may lie in the shadows and are not marked yet, and marks them.
    void find(const ReceiverBlocks& blocks, const ShadowAxes& axes, BlockMarks& marks,
              std::vector<std::size_t>& found) const;

    /// Whether an obstacle may give a cell of the block, on level ground, a horizon above this code. The
    /// margin exceeds rounding.
    [[nodiscard]] bool mayRaise(const ReceiverBlocks::Block& block, const ShadowAxes& axes,
                                HorizonCode code) const;

    [[nodiscard]] bool empty() const { return shadows_.empty(); }
    /// Extent of the obstacles in q, and of the tile along.
    [[nodiscard]] ShadowExtent extentIn(const ShadowExtent& tile) const;

private:
    struct Shadow {
        ShadowExtent extent;
        double foot;  ///< highest `along` of the obstacle
        double rise;  ///< scaled so that rise / (distance in `along`) is the tangent of the horizon
    };
    void find(const Shadow& shadow, const ReceiverBlocks& blocks, const ShadowAxes& axes, BlockMarks& marks,
              std::vector<std::size_t>& found) const;

    std::vector<Shadow> shadows_;
};

}  // namespace noonmark
