#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/simd/cache_line.h"

namespace noonmark {

/// Coordinates in which the shadows of one azimuth run over the cells of a grid. `along` is the grid axis
/// closer to the shadows' direction, oriented so that shadows run towards higher `along`; `across` is the
/// other axis. q = across - k along is constant along a shadow. Unit: cells, with cell centres at whole
/// numbers.
struct ShadowAxes {
    /// `away`: unit vector in which shadows fall.
    explicit ShadowAxes(glm::dvec2 away)
        : swapped(std::abs(away.x) > std::abs(away.y)),
          sign((swapped ? away.x : away.y) < 0 ? -1 : 1),
          alongPerDistance(std::abs(swapped ? away.x : away.y)),
          k((swapped ? away.y : away.x) / alongPerDistance) {}

    struct Point {
        double q;
        double along;
    };
    [[nodiscard]] Point from(glm::dvec2 cells) const {
        const double along = sign * (swapped ? cells.x : cells.y);
        return {(swapped ? cells.y : cells.x) - k * along, along};
    }

    /// Whether the mapping from (across, along) to (x, y) reverses orientation.
    [[nodiscard]] bool mirrored() const { return swapped != (sign < 0); }

    bool swapped;             ///< `along` is the x axis
    double sign;              ///< orientation of the axis: 1 or -1
    double alongPerDistance;  ///< `along` covered per unit of distance along the azimuth: 0.7 to 1
    double k;                 ///< -1 to 1
};

/// Bounding box of points in the axes of one azimuth.
struct ShadowExtent {
    double lowQ = 1e300, highQ = -1e300, lowAlong = 1e300, highAlong = -1e300;

    void add(const ShadowAxes::Point& point) {
        lowQ = std::min(lowQ, point.q);
        highQ = std::max(highQ, point.q);
        lowAlong = std::min(lowAlong, point.along);
        highAlong = std::max(highAlong, point.along);
    }
    void addBox(const ShadowAxes& axes, glm::dvec2 low, glm::dvec2 high) {
        const ShadowAxes::Point middle = axes.from((low + high) * 0.5);
        const glm::dvec2 half = (high - low) * 0.5;
        const double along = axes.swapped ? half.x : half.y, across = axes.swapped ? half.y : half.x;
        const double q = across + std::abs(axes.k) * along;
        add({middle.q - q, middle.along - along});
        add({middle.q + q, middle.along + along});
    }
};

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
