#pragma once

#include <algorithm>

#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/geometry/shadow_axes.h"

namespace noonmark {

/// A block in the axes of one azimuth.
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
    double across, q, along;  ///< of its first cell
    double lowestAlong, highestAlong;
    double lowQ, highQ;  ///< bounds of its cells, and a little more
};

/// Of a tile's cells.
inline ShadowExtent extentOf(const TileBox& box, const ShadowAxes& axes) {
    ShadowExtent extent;
    const glm::dvec2 low(box.firstColumn, box.firstRow);
    extent.addBox(axes, low, low + glm::dvec2(box.columns, box.rows));
    return extent;
}

/// Distances that are compared so, in cells, are wide of the rounding of what is found of walls and cells:
/// what is passed over for them changes no bit.
inline constexpr float nearlyOfDistance = 1 - 1e-5F, roundingOfDistance = 1e-2F;

/// Whether a wall this high gives a cell at this distance, or one farther off, a steeper horizon than one of
/// this cotangent. Wide of rounding: what it passes over changes no bit, in whatever order walls come.
inline bool mayRaise(float rise, double distance, float cot) {
    return double(rise) * double(cot) > distance * double(nearlyOfDistance) - double(roundingOfDistance);
}

}  // namespace noonmark
