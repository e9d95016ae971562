#include "core/accumulate/horizon/bin_sweep.h"

#include <algorithm>

namespace noonmark {

namespace {

constexpr int side = ReceiverBlocks::side;

/// A block in the axes of one azimuth.
struct BlockPlace {
    BlockPlace(const ReceiverBlocks::Block& block, const ShadowAxes& axes) {
        const ShadowAxes::Point first = axes.from({block.column, block.row});
        const ShadowAxes::Point last = axes.from({block.column + side - 1, block.row + side - 1});
        q = first.q;
        along = first.along;
        lowestAlong = std::min(first.along, last.along);
        highestAlong = std::max(first.along, last.along);
        const double shift = axes.k * axes.sign * (side - 1);
        lowQ = q - std::max(0.0, shift) - 1;
        highQ = q - std::min(0.0, shift) + side;
    }
    double q, along;  ///< of its first cell
    double lowestAlong, highestAlong;
    double lowQ, highQ;  ///< bounds of its cells, and a little more
};

// Whether a wall this high gives a cell at this distance, or one farther off, a steeper horizon. Wide of
// rounding: what it passes over changes no bit, in whatever order walls come.
bool mayRaise(float rise, double distance, float steepness) {
    return double(rise) * (1 - double(steepness)) > double(steepness) * (distance * (1 - 1e-5) - 1e-2);
}

WallOnBlock onBlock(const WallPiece& piece, const BlockPlace& block) {
    return {.low = float(block.q - piece.lowQ),
            .high = float(block.q - piece.highQ),
            .along = float(block.along - piece.along0),
            .slope = piece.slope,
            .rise = piece.rise,
            .nearest = piece.nearest};
}

void writeCodes(const BlockHorizons& horizons, HorizonCode lowest, const ReceiverBlocks& blocks,
                const ReceiverBlocks::Block& block, bool swapped, HorizonCode* codes) {
    alignas(64) HorizonCode square[ReceiverBlocks::cells];
    codesOf(horizons, lowest, square);
    const std::uint8_t* places = blocks.places(block, swapped);
    HorizonCode* to = codes + block.first;
    for (std::uint32_t i = 0; i < block.count; ++i) to[i] = square[places[i]];
    std::fill(to + block.count, to + (block.count + 31) / 32 * 32, noHorizon);
}

}  // namespace

std::uint64_t BinSweep::sweep(const WallList& walls, const ReceiverBlocks& blocks, glm::dvec2 away,
                              HorizonCode lowest, double cellM, HorizonCode* codes,
                              const std::stop_token& stop) {
    const ShadowAxes axes(away);
    const BlockLines lines(axes.k, axes.sign);
    const float steepness = steepnessOf(lowest);
    walls_.find(walls, walls.prisms, axes, blocks.box(), cellM, steepness / (1 - steepness));
    for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
        if (i % 256 == 0 && stop.stop_requested()) break;
        const ReceiverBlocks::Block& block = blocks.blocks()[i];
        clearBlock(blocks.masks(i, axes.swapped), horizons_);
        raise(block, axes, lines, steepness);
        writeCodes(horizons_, lowest, blocks, block, axes.swapped, codes);
    }
    return walls_.prismsOutOfReach();
}

// Near walls first. `lowest`: a steepness that all horizons below are the same to.
void BinSweep::raise(const ReceiverBlocks::Block& block, const ShadowAxes& axes, const BlockLines& lines,
                     float lowest) {
    const BlockPlace place(block, axes);
    const BinWalls::Bands bands = walls_.bandsOf(place.lowQ, place.highQ);
    const float level = lowest;
    // A piece is 16 deep: those that begin a row beyond the block may come down into it.
    for (int row = std::max(0, walls_.rowOf(place.highestAlong) - 1); row < walls_.rows(); ++row) {
        if (!mayRaise(walls_.tallest(row, bands), place.lowestAlong - walls_.highestAlong(row), lowest))
            break;
        bool raised = false;
        for (const WallPiece& piece : walls_.pieces(row, bands)) {
            if (piece.highQ <= place.lowQ || piece.lowQ >= place.highQ) continue;
            if (!mayRaise(piece.rise, place.lowestAlong - double(piece.highAlong), lowest)) continue;
            raiseBlock(onBlock(piece, place), lines, horizons_);
            raised = true;
        }
        if (raised) lowest = std::max(level, lowestOf(horizons_));
    }
}

}  // namespace noonmark
