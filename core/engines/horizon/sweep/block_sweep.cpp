#include "core/engines/horizon/sweep/block_sweep.h"

#include <algorithm>

namespace noonmark {

namespace {

// Gives the same bits as findRaisingAzimuths() does for a wall, because edits process some obstacles with
// this function and some with that one.
WallOnBlock onBlock(const WallPiece& piece, const BlockPlace& block, double k) {
    const glm::dvec2 first(block.across, block.along), a = first - piece.low, b = first - piece.high;
    const double low = a.x - k * a.y, high = b.x - k * b.y;
    const auto slope = float((a.y - b.y) / (low - high));
    return {.low = float(low),
            .high = float(high),
            .along = float(a.y),
            .slope = slope,
            .rise = piece.rise,
            .riseSlope = piece.riseSlope,
            .nearest = computeNearestAlong(piece.nearest, slope),
            .building = std::int32_t(piece.building)};
}

// The horizons that an edge must exceed to change anything.
const CacheLine<float>* seenOver(const UnevenHorizons& horizons) { return horizons.rows; }
const CacheLine<float>* seenOver(const AttributedHorizons& horizons) { return horizons.others.rows; }

}  // namespace

void BlockSweep::begin(const WallList& walls, const Obstacles& obstacles, glm::dvec2 away,
                       const ShadowExtent& extent, HorizonCode lowest, double cellM,
                       const std::stop_token& stop) {
    const ShadowAxes axes(away);
    axes_ = axes;
    rows_ = BlockRows(axes.k, axes.sign);
    const SweptBin bin{away, lowest};
    batch_.begin({&bin, 1}, cellM);
    lowest_ = lowest;
    even_ = obstacles.even();
    risePerMetre_ = float(axes.alongPerDistance / cellM);
    walls_.find(walls, obstacles, away, extent, cellM, 1 / toCotangent(lowest), stop);
}

// If cells have individual heights, the rise that an edge needs grows with the distance.
template <class Horizons>
bool BlockSweep::raise(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
                       const BlockGround& ground, Horizons& horizons) {
    const BlockPlace place(block, axes_);
    const BinWalls::Bands bands = walls_.bandsOf(place.lowQ, place.highQ);
    const float level = toCotangent(lowest_), foot = ground.lowestM * risePerMetre_;
    const auto distance = [&](int row) { return place.lowestAlong - walls_.highestAlong(row); };
    int row = std::max(0, walls_.rowOf(place.highestAlong) - 1);
    const auto mayMatter = [&] { return mayRaise(walls_.tallest(row, bands) - foot, distance(row), level); };
    if (row >= walls_.rows() || !mayMatter()) return false;
    clearBlock(masks, horizons);
    setGrounds(ground, risePerMetre_, horizons.grounds);
    findNeed(seenOver(horizons), horizons.grounds, level, need_);
    bool any = false;
    for (; row < walls_.rows(); ++row) {
        const float least = findLeastRise(need_, rows_, float(place.along - walls_.highestAlong(row)));
        if (walls_.tallest(row, bands) <= least) break;
        if (walls_.tallestIn(row, bands) <= least) continue;
        bool raised = false;
        for (const WallPiece& piece : walls_.pieces(row, bands)) {
            if (piece.highQ <= place.lowQ || piece.lowQ >= place.highQ || piece.highRise <= least) continue;
            raiseBlock(onBlock(piece, place, axes_.k), rows_, horizons);
            raised = any = true;
        }
        if (raised) findNeed(seenOver(horizons), horizons.grounds, level, need_);
    }
    return any;
}

const HorizonCode* BlockSweep::codes(const ReceiverBlocks::Block& block, const ReceiverBlocks::Masks& masks,
                                     const BlockGround& ground) {
    if (even_ && ground.rowsM == nullptr) {
        batch_.raise(walls_, block, masks);
        return batch_.codes(0);
    }
    if (!raise(block, masks, ground, uneven_)) return nullptr;
    toCodes(uneven_, lowest_, codes_);
    return codes_;
}

const AttributedCodes* BlockSweep::attributedCodes(const ReceiverBlocks::Block& block,
                                                   const ReceiverBlocks::Masks& masks,
                                                   const BlockGround& ground) {
    if (!raise(block, masks, ground, ranked_)) return nullptr;
    toCodes(ranked_, lowest_, rankedCodes_);
    return &rankedCodes_;
}

}  // namespace noonmark
