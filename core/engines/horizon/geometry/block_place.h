#pragma once

#include <algorithm>

#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"

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

}  // namespace noonmark
