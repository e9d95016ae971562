#include "core/engines/horizon/sweep/batch_horizons.h"

#include <algorithm>
#include <bit>

#include "core/engines/horizon/sweep/batch_walls.h"

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
    std::copy_n(lanes_->cotOfLowest, BatchLanes::most, cots_);
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
        if (waiting.count == Waiting::most) raise(bin, masks);
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

}  // namespace noonmark
