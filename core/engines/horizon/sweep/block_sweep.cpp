#include "core/engines/horizon/sweep/block_sweep.h"

#include <algorithm>
#include <bit>

namespace noonmark {

void BatchHorizons::begin(std::span<const SweptBin> bins, double cellM) {
    lanes_.emplace(bins, cellM);
    lowest_.clear();
    rows_.clear();
    for (const SweptBin& bin : bins) {
        const ShadowAxes axes(bin.away);
        lowest_.push_back(bin.lowest);
        rows_.emplace_back(axes.k, axes.sign);
    }
}

// Cotangent of the lowest horizon of any azimuth, scaled to rises at the middle azimuth.
float BatchHorizons::highestCot() const {
    float highest = 0;
    for (int i = 0; i < lanes_->count; ++i) highest = std::max(highest, cots_[i] * lanes_->riseOfMiddle[i]);
    return highest;
}

void BatchHorizons::raise(const BinWalls& walls, const ReceiverBlocks::Block& block,
                          const ReceiverBlocks::Masks& masks) {
    const BlockPlace place(block, lanes_->batch.axes);
    std::copy_n(lanes_->cotOfLowest, BatchLanes::maximum, cots_);
    raised_ = 0;
    const int rows = walls.rows();
    const BinWalls::Bands all = walls.bandsOf(place.lowQ, place.highQ, place.highestAlong, rows - 1);
    const bool narrow = batch().spread == 0;
    float cot = highestCot();
    // Pieces are up to 16 deep, so pieces that begin one row beyond the block may extend into it.
    for (int row = std::max(walls.firstRow(), walls.rowOf(place.highestAlong) - 1); row < rows; ++row) {
        const double distance = place.lowestAlong - walls.highestAlong(row);
        if (!mayRaise(walls.tallest(row, all), distance, cot)) break;
        if (!mayRaise(walls.tallestIn(row, all), distance, cot)) continue;
        const BinWalls::Bands bands =
            narrow ? all : walls.bandsOf(place.lowQ, place.highQ, place.highestAlong, row);
        walls.forEachCandidate(row, bands, walls.makeQuery(place.lowQ, place.highQ, place.lowestAlong, cot),
                               [&](const WallPiece& piece) { add(piece, place, masks); });
        if (raiseWaiting(masks)) cot = highestCot();
    }
}

void BatchHorizons::add(const WallPiece& piece, const BlockPlace& place, const ReceiverBlocks::Masks& masks) {
    const glm::dvec2 first(place.across, place.along);
    const WallAhead wall{first - piece.low, first - piece.high, piece.topM,
                         float(place.lowestAlong - double(piece.highAlong))};
    WallInBatch in;
    for (unsigned may = findRaisingAzimuths(*lanes_, cots_, wall, in); may != 0; may &= may - 1) {
        const auto bin = std::size_t(std::countr_zero(may));
        Waiting& waiting = waiting_[bin];
        waiting.walls[waiting.count++] = {.low = in.low[bin],
                                          .high = in.high[bin],
                                          .along = float(wall.low.y),
                                          .slope = in.slope[bin],
                                          .nearest = computeNearestAlong(piece.nearest, in.slope[bin]),
                                          .perRise = in.perRise[bin],
                                          .ahead = wall.nearestAlong > aheadBy};
        if (waiting.count == Waiting::maximum) raise(bin, masks);
    }
}

// Returns whether there were any walls waiting.
bool BatchHorizons::raiseWaiting(const ReceiverBlocks::Masks& masks) {
    bool any = false;
    for (std::size_t bin = 0; bin < lowest_.size(); ++bin)
        if (waiting_[bin].count > 0) {
            raise(bin, masks);
            any = true;
        }
    return any;
}

void BatchHorizons::raise(std::size_t bin, const ReceiverBlocks::Masks& masks) {
    if ((raised_ >> bin & 1U) == 0) clearBlock(masks, horizons_[bin]);
    raised_ |= 1U << bin;
    const std::span<const WallOnBlock> walls(waiting_[bin].walls.data(), waiting_[bin].count);
    cots_[bin] = std::min(lanes_->cotOfLowest[bin], raiseBlock(walls, rows_[bin], horizons_[bin]));
    waiting_[bin].count = 0;
}

const HorizonCode* BatchHorizons::codes(std::size_t bin) {
    if ((raised_ >> bin & 1U) == 0) return nullptr;
    toCodes(horizons_[bin], lowest_[bin], codes_);
    return codes_;
}

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
        const float minimum = findMinRise(need_, rows_, float(place.along - walls_.highestAlong(row)));
        if (walls_.tallest(row, bands) <= minimum) break;
        if (walls_.tallestIn(row, bands) <= minimum) continue;
        bool raised = false;
        for (const WallPiece& piece : walls_.pieces(row, bands)) {
            if (piece.highQ <= place.lowQ || piece.lowQ >= place.highQ || piece.highRise <= minimum) continue;
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
