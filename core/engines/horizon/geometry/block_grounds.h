#pragma once

#include <algorithm>
#include <vector>

#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/simd/cache_line.h"

namespace noonmark {

/// Position of a block in the axes of one azimuth.
struct BlockPlace {
    BlockPlace(const ReceiverBlocks::Block& block, const ShadowAxes& axes) {
        constexpr int side = ReceiverBlocks::side;
        const ShadowAxes::Point first = axes.from({block.column, block.row});
        const ShadowAxes::Point last = axes.from({block.column + side - 1, block.row + side - 1});
        across = axes.swapped ? block.row : block.column;
        q = first.q;
        along = first.along;
        lowestAlong = std::min(first.along, last.along);
        highestAlong = std::max(first.along, last.along);
        const double shift = axes.k * axes.sign * (side - 1);
        lowQ = q - std::max(0.0, shift) - 1;
        highQ = q - std::min(0.0, shift) + side;
    }
    double across, q, along;  ///< of the block's first cell
    double lowestAlong, highestAlong;
    double lowQ, highQ;  ///< bounds of its cells with a margin
};

/// Extent of a tile's cells.
inline ShadowExtent extentOf(const TileBox& box, const ShadowAxes& axes) {
    ShadowExtent extent;
    const glm::dvec2 low(box.firstColumn, box.firstRow);
    extent.addBox(axes, low, low + glm::dvec2(box.columns, box.rows));
    return extent;
}

/// Margins for comparing distances in cells. They exceed the rounding of positions of walls and cells, so
/// that what they exclude changes no bit of the result.
inline constexpr float nearlyOfDistance = 1 - 1e-5F, roundingOfDistance = 1e-2F;

/// Whether a wall this high may give a cell at this distance, or one farther away, a steeper horizon than one
/// with this cotangent. The margin exceeds rounding, so walls that it excludes change no bit, in whatever
/// order walls come.
inline bool mayRaise(float rise, double distance, float cot) {
    return double(rise) * double(cot) > distance * double(nearlyOfDistance) - double(roundingOfDistance);
}

/// Ground heights of the cells of a block.
struct BlockGround {
    const CacheLine<float>* rowsM =
        nullptr;        ///< above the datum, row by row, 16 each; null: all at the datum
    float lowestM = 0;  ///< lowest of the receivers
};

/// Elevations of a tile's receivers, in the row order of its blocks; empty if they are flat. They are those
/// of the reference's rays, a millimetre above the ground, so that both treat a receiver's own ground alike.
class BlockGrounds {
public:
    BlockGrounds() = default;  ///< flat ground
    /// 2 kB per block.
    BlockGrounds(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);

    [[nodiscard]] bool flat() const { return rows_.empty(); }
    [[nodiscard]] BlockGround of(std::size_t block, bool swapped) const;

private:
    std::vector<CacheLine<float>> rows_, columns_;  // 16 per block
    std::vector<float> lowestM_;                    // one per block
};

}  // namespace noonmark
