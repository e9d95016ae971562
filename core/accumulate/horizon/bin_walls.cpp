#include "core/accumulate/horizon/bin_walls.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

// Wide of the rounding of distances, cells.
constexpr float onTheWall = 1e-3F;

// A receiver on a wall counts as just east and north of it. So little behind that it is inside, it would be
// no receiver.
float nearestOf(const StandingWall& wall) {
    const glm::dvec2 edge = wall.b - wall.a;
    return edge.y > edge.x ? -onTheWall : onTheWall;
}

}  // namespace

void BinWalls::find(const WallList& list, std::span<const StandingPrism> prisms, const ShadowAxes& axes,
                    const ShadowExtent& tile, double cellM, float lowestTan) {
    found_.clear();
    outOfReach_ = 0;
    alongPerMetre_ = axes.alongPerDistance / cellM;
    lowestTan_ = double(lowestTan);
    tile_ = tile;
    for (const StandingPrism& prism : prisms) addPrism(list, prism, axes);
    sort();
}

bool BinWalls::inReach(const ShadowExtent& extent, double reach) const {
    return extent.highQ > tile_.lowQ && extent.lowQ < tile_.highQ && extent.lowAlong <= tile_.highAlong &&
           extent.highAlong + reach >= tile_.lowAlong;
}

void BinWalls::addPrism(const WallList& list, const StandingPrism& prism, const ShadowAxes& axes) {
    const double rise = double(prism.topM) * alongPerMetre_;
    reach_ = rise / lowestTan_ + 1;
    ShadowExtent extent;
    extent.addBox(axes, prism.low, prism.high);
    if (!inReach(extent, reach_)) {
        ++outOfReach_;
        return;
    }
    for (const StandingWall& wall : list.wallsOf(prism)) {
        const ShadowAxes::Point a = axes.from(wall.a), b = axes.from(wall.b);
        const bool facesAway = axes.mirrored() ? a.q < b.q : b.q < a.q;
        if (!facesAway) continue;
        const WallPiece piece{.rise = float(rise), .nearest = nearestOf(wall), .building = prism.building};
        a.q < b.q ? addWall(a, b, piece) : addWall(b, a, piece);
    }
}

void BinWalls::addWall(const ShadowAxes::Point& a, const ShadowAxes::Point& b, WallPiece piece) {
    const double wide = b.q - a.q, deep = b.along - a.along;
    const double slope = deep / wide;
    const int count = int(std::ceil(std::max({1.0, wide / bandWidth, std::abs(deep) / rowDepth})));
    const auto cut = [&](int i) { return i == count ? b.q : a.q + wide * i / count; };
    piece.slope = float(slope);
    for (int i = 0; i < count; ++i) {
        piece.lowQ = cut(i);
        piece.highQ = cut(i + 1);
        piece.along0 = a.along + slope * (piece.lowQ - a.q);
        const double other = i + 1 == count ? b.along : a.along + slope * (piece.highQ - a.q);
        piece.highAlong = float(std::max(piece.along0, other));
        if (inReach({piece.lowQ, piece.highQ, std::min(piece.along0, other), double(piece.highAlong)},
                    reach_))
            found_.push_back(piece);
    }
}

int BinWalls::rowOf(double along) const { return lastStep_ - int(std::floor(along / rowDepth)); }

std::size_t BinWalls::slotOf(const WallPiece& piece) const {
    return std::size_t(std::max(0, rowOf(double(piece.highAlong)))) * std::size_t(bands_) +
           std::size_t(int(std::floor(piece.lowQ / bandWidth)) - firstBand_);
}

// By counting.
void BinWalls::sort() {
    double lowest = tile_.highAlong;
    for (const WallPiece& piece : found_) lowest = std::min(lowest, double(piece.highAlong));
    firstBand_ = int(std::floor(tile_.lowQ / bandWidth)) - 2;  // pieces may begin a band before the tile
    bands_ = int(std::floor(tile_.highQ / bandWidth)) - firstBand_ + 1;
    lastStep_ = int(std::floor(tile_.highAlong / rowDepth)) + 1;
    rows_ = rowOf(lowest) + 1;
    starts_.assign(std::size_t(rows_) * std::size_t(bands_) + 2, 0);
    tallest_.assign(std::size_t(rows_ + 1) * std::size_t(bands_), 0);
    for (const WallPiece& piece : found_) {
        const std::size_t slot = slotOf(piece);
        ++starts_[slot + 2];
        tallest_[slot] = std::max(tallest_[slot], piece.rise);
    }
    for (std::size_t i = 2; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    sorted_.resize(found_.size());
    for (const WallPiece& piece : found_) sorted_[starts_[slotOf(piece) + 1]++] = piece;
    for (std::size_t i = std::size_t(rows_) * std::size_t(bands_); i-- > 0;)
        tallest_[i] = std::max(tallest_[i], tallest_[i + std::size_t(bands_)]);
}

BinWalls::Bands BinWalls::bandsOf(double lowQ, double highQ) const {
    return {std::clamp(int(std::floor(lowQ / bandWidth)) - 1 - firstBand_, 0, bands_),
            std::clamp(int(std::floor(highQ / bandWidth)) + 1 - firstBand_, 0, bands_)};
}

std::span<const WallPiece> BinWalls::pieces(int row, const Bands& bands) const {
    const std::size_t slot = std::size_t(row) * std::size_t(bands_);
    const std::uint32_t first = starts_[slot + std::size_t(bands.first)],
                        end = starts_[slot + std::size_t(bands.end)];
    return std::span(sorted_).subspan(first, end - first);
}

float BinWalls::tallest(int row, const Bands& bands) const {
    const float* of = tallest_.data() + std::size_t(row) * std::size_t(bands_);
    return *std::max_element(of + bands.first, of + bands.end);
}

}  // namespace noonmark
