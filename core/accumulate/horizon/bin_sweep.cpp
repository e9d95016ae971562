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
bool mayRaise(float rise, double distance, float cot) {
    return double(rise) * double(cot) > distance * (1 - 1e-5) - 1e-2;
}

WallOnBlock onBlock(const WallPiece& piece, const BlockPlace& block) {
    return {.low = float(block.q - piece.lowQ),
            .high = float(block.q - piece.highQ),
            .along = float(block.along - piece.along0),
            .slope = piece.slope,
            .rise = piece.rise,
            .riseSlope = piece.riseSlope,
            .nearest = piece.nearest,
            .perRise = piece.perRise,
            .building = std::int32_t(piece.building)};
}

// What an edge must surpass to change something.
const Floats16* seenOver(const UnevenHorizons& horizons) { return horizons.lines; }
const Floats16* seenOver(const RankedHorizons& horizons) { return horizons.others; }

void write(const HorizonCode* square, const ReceiverBlocks& blocks, const ReceiverBlocks::Block& block,
           bool swapped, HorizonCode* codes) {
    HorizonCode* to = codes + block.first;
    const std::uint32_t padded = (block.count + 31) / 32 * 32;
    const std::uint8_t* places = blocks.places(block, swapped);
    const std::uint32_t written = square == nullptr ? 0 : block.count;
    for (std::uint32_t i = 0; i < written; ++i) to[i] = square[places[i]];
    std::fill(to + written, to + padded, noHorizon);
}

}  // namespace

ShadowExtent extentOf(const TileBox& box, const ShadowAxes& axes) {
    ShadowExtent extent;
    const glm::dvec2 low(box.firstColumn, box.firstRow);
    extent.addBox(axes, low, low + glm::dvec2(box.columns, box.rows));
    return extent;
}

std::uint64_t sweepBin(SquareSweep& sweep, const WallList& walls, const ReceiverBlocks& blocks,
                       const BlockGrounds& grounds, glm::dvec2 away, HorizonCode lowest, double cellM,
                       std::span<HorizonCode> codes, const std::stop_token& stop) {
    const ShadowAxes axes(away);
    sweep.begin(walls, allOf(walls), away, extentOf(blocks.box(), axes), lowest, cellM, stop);
    for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
        if (i % 256 == 0 && stop.stop_requested()) break;
        const ReceiverBlocks::Block& block = blocks.blocks()[i];
        const HorizonCode* square =
            sweep.codes(block, blocks.masks(i, axes.swapped), grounds.of(i, axes.swapped));
        write(square, blocks, block, axes.swapped, codes.data());
    }
    return sweep.outOfReach();
}

void rankBin(SquareSweep& sweep, const WallList& walls, const ReceiverBlocks& blocks,
             const BlockGrounds& grounds, glm::dvec2 away, HorizonCode lowest, double cellM, TileRanks& ranks,
             const std::stop_token& stop) {
    const ShadowAxes axes(away);
    ranks.codes.assign(blocks.numbers(), noHorizon);
    ranks.others.assign(blocks.numbers(), noHorizon);
    ranks.buildings.resize(blocks.numbers());
    sweep.begin(walls, allOf(walls), away, extentOf(blocks.box(), axes), lowest, cellM, stop);
    for (std::size_t i = 0; i < blocks.blocks().size() && !stop.stop_requested(); ++i) {
        const ReceiverBlocks::Block& block = blocks.blocks()[i];
        const RankedCodes* square =
            sweep.rankedCodes(block, blocks.masks(i, axes.swapped), grounds.of(i, axes.swapped));
        const std::uint8_t* places = blocks.places(block, axes.swapped);
        for (std::uint32_t n = 0; square != nullptr && n < block.count; ++n) {
            ranks.codes[block.first + n] = square->codes[places[n]];
            ranks.others[block.first + n] = square->others[places[n]];
            ranks.buildings[block.first + n] = std::uint32_t(square->buildings[places[n]]);
        }
    }
}

void SquareSweep::begin(const WallList& walls, const Obstacles& obstacles, glm::dvec2 away,
                        const ShadowExtent& extent, HorizonCode lowest, double cellM,
                        const std::stop_token& stop) {
    const ShadowAxes axes(away);
    axes_ = axes;
    lines_ = BlockLines(axes.k, axes.sign);
    lowest_ = lowest;
    even_ = obstacles.even();
    risePerMetre_ = float(axes.alongPerDistance / cellM);
    walls_.find(walls, obstacles, away, extent, cellM, 1 / cotOf(lowest), stop);
}

bool SquareSweep::raise(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
                        BlockHorizons& horizons) {
    const BlockPlace place(block, axes_);
    const BinWalls::Bands bands = walls_.bandsOf(place.lowQ, place.highQ);
    const float level = cotOf(lowest_);
    float lowest = level;
    bool any = false;
    // A piece is 16 deep: those that begin a row beyond the block may come down into it.
    for (int row = std::max(0, walls_.rowOf(place.highestAlong) - 1); row < walls_.rows(); ++row) {
        if (!mayRaise(walls_.tallest(row, bands), place.lowestAlong - walls_.highestAlong(row), lowest))
            break;
        bool raised = false;
        const BlockSight sight = walls_.sightFrom(place.lowQ, place.highQ, place.lowestAlong, lowest);
        walls_.forEachSeen(row, bands, sight, [&](const WallPiece& piece) {
            if (!any) clearBlock(masks, horizons);
            raiseBlock(onBlock(piece, place), lines_, horizons);
            raised = any = true;
        });
        if (raised) lowest = std::min(level, lowestOf(horizons));
    }
    return any;
}

// The same, where each cell has a height of its own: what it asks of an edge grows with the distance.
template <class Horizons>
bool SquareSweep::raise(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
                        const BlockGround& ground, Horizons& horizons) {
    const BlockPlace place(block, axes_);
    const BinWalls::Bands bands = walls_.bandsOf(place.lowQ, place.highQ);
    const float level = cotOf(lowest_), foot = ground.lowestM * risePerMetre_;
    const auto distance = [&](int row) { return place.lowestAlong - walls_.highestAlong(row); };
    int row = std::max(0, walls_.rowOf(place.highestAlong) - 1);
    const auto mayMatter = [&] { return mayRaise(walls_.tallest(row, bands) - foot, distance(row), level); };
    if (row >= walls_.rows() || !mayMatter()) return false;
    clearBlock(masks, horizons);
    setGrounds(ground, risePerMetre_, horizons.grounds);
    findNeed(seenOver(horizons), horizons.grounds, level, need_);
    bool any = false;
    for (; row < walls_.rows(); ++row) {
        const float least = leastRise(need_, lines_, float(place.along - walls_.highestAlong(row)));
        if (walls_.tallest(row, bands) <= least) break;
        if (walls_.tallestIn(row, bands) <= least) continue;
        bool raised = false;
        for (const WallPiece& piece : walls_.pieces(row, bands)) {
            if (piece.highQ <= place.lowQ || piece.lowQ >= place.highQ || piece.highRise <= least) continue;
            raiseBlock(onBlock(piece, place), lines_, horizons);
            raised = any = true;
        }
        if (raised) findNeed(seenOver(horizons), horizons.grounds, level, need_);
    }
    return any;
}

const HorizonCode* SquareSweep::codes(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
                                      const BlockGround& ground) {
    const bool even = even_ && ground.linesM == nullptr;
    if (!(even ? raise(block, masks, horizons_) : raise(block, masks, ground, uneven_))) return nullptr;
    codesOf(even ? horizons_ : uneven_, lowest_, codes_);
    return codes_;
}

const RankedCodes* SquareSweep::rankedCodes(const ReceiverBlocks::Block& block,
                                            const ReceiverBlocks::Masks& masks, const BlockGround& ground) {
    if (!raise(block, masks, ground, ranked_)) return nullptr;
    codesOf(ranked_, lowest_, rankedCodes_);
    return &rankedCodes_;
}

}  // namespace noonmark
