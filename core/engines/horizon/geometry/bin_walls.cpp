#include "core/engines/horizon/geometry/bin_walls.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

// Exceeds the rounding of the distance, in cells, to a wall that the azimuth crosses at a right angle.
constexpr float onTheWall = 1e-4F;

constexpr double maxAcross = 32;  // cells per piece

// A receiver on a wall counts as just east and north of it. A position this close behind the wall would be
// inside the building and hence no receiver.
float nearestOf(const StandingWall& wall) {
    const glm::dvec2 edge = wall.b - wall.a;
    return edge.y > edge.x ? -onTheWall : onTheWall;
}

// The same for the face behind an edge. On a sloping face, only receivers below the edge can lie on it.
float nearestOf(glm::vec3 outward) {
    constexpr float plumb = 1e-6F;
    return std::abs(outward.z) <= plumb && outward.x + outward.y > 0 ? -onTheWall : onTheWall;
}

}  // namespace

void BinWalls::find(const WallList& list, const Obstacles& obstacles, glm::dvec2 away,
                    const ShadowExtent& tile, double cellM, float lowestTan, const std::stop_token& stop) {
    begin({ShadowAxes(away)}, tile, cellM, lowestTan);
    for (const StandingPrism& prism : obstacles.prisms) addPrism(list, prism);
    for (const StandingSolid& solid : obstacles.solids) addSolid(solid, glm::vec2(away));
    if (obstacles.terrain != nullptr) addTerrain(*obstacles.terrain, list.terrainNumber, away, stop);
    sort();
}

void BinWalls::find(const WallList& list, std::span<const StandingPrism> prisms, const AzimuthBatch& batch,
                    const ShadowExtent& tile, double cellM, float lowestTan) {
    begin(batch, tile, cellM, lowestTan);
    for (const StandingPrism& prism : prisms) addPrism(list, prism);
    sort();
}

void BinWalls::begin(const AzimuthBatch& batch, const ShadowExtent& tile, double cellM, float lowestTan) {
    found_.clear();
    outOfReach_ = 0;
    axes_ = batch.axes;
    spread_ = batch.spread;
    alongPerMetre_ = axes_.alongPerDistance / cellM;
    lowestTan_ = double(lowestTan);
    tile_ = tile;
}

// True if in reach along some azimuth of the batch.
bool BinWalls::inReach(const ShadowExtent& extent, double reach) const {
    const double farthest = std::min(extent.highAlong + reach, tile_.highAlong) - extent.lowAlong;
    const double aside = spread_ * std::max(0.0, farthest);
    return extent.highQ + aside > tile_.lowQ && extent.lowQ - aside < tile_.highQ &&
           extent.lowAlong <= tile_.highAlong && extent.highAlong + reach >= tile_.lowAlong;
}

// Stores in reach_ how far an obstacle of this rise can cast shadow, in cells along.
bool BinWalls::reachesTile(glm::dvec2 low, glm::dvec2 high, double rise) {
    reach_ = rise / lowestTan_ + 1;
    ShadowExtent extent;
    extent.addBox(axes_, low, high);
    const bool reaches = inReach(extent, reach_);
    if (!reaches) ++outOfReach_;
    return reaches;
}

// Returns across and along.
glm::dvec2 BinWalls::from(glm::dvec2 cells) const {
    return {axes_.swapped ? cells.y : cells.x, axes_.sign * (axes_.swapped ? cells.x : cells.y)};
}

// Whether a wall from its low end a to its high end b faces away from the sun at some azimuth of the batch.
bool BinWalls::facesAway(glm::dvec2 a, glm::dvec2 b) const {
    return qOf(b) - qOf(a) + spread_ * std::abs(b.y - a.y) > 0;
}

void BinWalls::addPrism(const WallList& list, const StandingPrism& prism) {
    const double rise = double(prism.topM) * alongPerMetre_;
    if (!(rise > 0) || !reachesTile(prism.low, prism.high, rise)) return;
    for (const StandingWall& wall : list.wallsOf(prism)) {
        const glm::dvec2 a = from(axes_.mirrored() ? wall.a : wall.b),
                         b = from(axes_.mirrored() ? wall.b : wall.a);
        if (facesAway(a, b))
            addPieces({a, rise}, {b, rise},
                      {.topM = prism.topM, .nearest = nearestOf(wall), .building = prism.building});
    }
}

void BinWalls::addSolid(const StandingSolid& solid, glm::vec2 away) {
    if (!reachesTile(solid.low, solid.high, double(solid.topM) * alongPerMetre_)) return;
    backLit_.clear();
    for (const glm::vec3 normal : solid.normals) backLit_.push_back(backLitBelow(normal, away));
    for (const SolidEdge& edge : solid.edges)
        if (edge.right == SolidEdge::noFace ||
            isOutline(backLit_[edge.left], backLit_[edge.right], float(lowestTan_)))
            addEdge(solid, edge);
}

void BinWalls::addEdge(const StandingSolid& solid, const SolidEdge& edge) {
    const glm::dvec3 a = solid.vertices[edge.a], b = solid.vertices[edge.b];
    const bool leftIsBehind = edge.right == SolidEdge::noFace || backLit_[edge.left] > backLit_[edge.right];
    const glm::vec3 behind = solid.normals[leftIsBehind ? edge.left : edge.right];
    addUpwards({from(glm::dvec2(a)), a.z * alongPerMetre_}, {from(glm::dvec2(b)), b.z * alongPerMetre_},
               {.nearest = nearestOf(behind), .building = solid.building});
}

// Searches all squares of the terrain; receivers lie at the datum or above.
void BinWalls::addTerrain(const TerrainEdges& terrain, std::uint32_t number, glm::dvec2 away,
                          const std::stop_token& stop) {
    terrain.find({.axes = axes_,
                  .away = away,
                  .tile = tile_,
                  .lowestTan = lowestTan_,
                  .alongPerMetre = alongPerMetre_},
                 edges_, stop);
    const auto at = [&](const ShadowAxes::Point& point) {
        return glm::dvec2(point.q + axes_.k * point.along, point.along);
    };
    for (const TerrainEdges::Edge& edge : edges_) {
        const double rise = std::max(edge.aM, edge.bM) * alongPerMetre_;
        reach_ = rise / lowestTan_ + 1;
        if (rise > 0)
            addUpwards({at(edge.a), edge.aM * alongPerMetre_}, {at(edge.b), edge.bM * alongPerMetre_},
                       {.nearest = onTheWall, .building = number});
    }
}

// Either end may have the lower q.
void BinWalls::addUpwards(const End& a, const End& b, const WallPiece& piece) {
    if (!(std::max(a.rise, b.rise) > 0)) return;
    if (qOf(a.at) < qOf(b.at))
        addPieces(a, b, piece);
    else if (qOf(b.at) < qOf(a.at))
        addPieces(b, a, piece);
}

void BinWalls::addPieces(const End& a, const End& b, WallPiece piece) {
    const glm::dvec2 size = b.at - a.at;
    const double parts = std::max(std::abs(size.x) / maxAcross, std::abs(size.y) / rowDepth);
    const int count = parts <= 1 ? 1 : int(std::ceil(parts));
    const auto cut = [&](int i) { return i == count ? b.at : a.at + size * (double(i) / count); };
    for (int i = 0; i < count; ++i) {
        piece.low = cut(i);
        piece.high = cut(i + 1);
        setRises(a, b, piece);
        const auto [lowQ, highQ] = std::minmax(piece.lowQ, piece.highQ);
        if (inReach({lowQ, highQ, std::min(piece.low.y, piece.high.y), double(piece.highAlong)}, reach_))
            found_.push_back(piece);
    }
}

void BinWalls::setRises(const End& a, const End& b, WallPiece& piece) const {
    piece.lowQ = qOf(piece.low);
    piece.highQ = qOf(piece.high);
    piece.highAlong = float(std::max(piece.low.y, piece.high.y));
    const double firstQ = qOf(a.at), slope = a.rise == b.rise ? 0 : (b.rise - a.rise) / (qOf(b.at) - firstQ);
    const double rise = a.rise + slope * (piece.lowQ - firstQ),
                 other = a.rise + slope * (piece.highQ - firstQ);
    piece.riseSlope = float(slope);
    piece.rise = float(rise);
    piece.highRise = float(std::max(rise, other));
}

int BinWalls::rowOf(double along) const { return lastStep_ - int(std::floor(along / rowDepth)); }

std::size_t BinWalls::slotOf(const WallPiece& piece) const {
    return std::size_t(std::max(0, rowOf(double(piece.highAlong)))) * std::size_t(bands_) +
           std::size_t(int(std::floor(std::min(piece.lowQ, piece.highQ) / bandWidth)) - firstBand_);
}

// A counting sort.
void BinWalls::sort() {
    double lowest = tile_.highAlong, highest = found_.empty() ? lowest : double(found_.front().highAlong),
           lowQ = tile_.lowQ, highQ = tile_.highQ;
    for (const WallPiece& piece : found_) {
        lowest = std::min(lowest, double(piece.highAlong));
        highest = std::max(highest, double(piece.highAlong));
        lowQ = std::min({lowQ, piece.lowQ, piece.highQ});
        highQ = std::max(highQ, piece.lowQ);
    }
    firstBand_ = int(std::floor(lowQ / bandWidth));
    bands_ = int(std::floor(highQ / bandWidth)) - firstBand_ + 1;
    lastStep_ = int(std::floor(tile_.highAlong / rowDepth)) + 1;
    rows_ = rowOf(lowest) + 1;
    firstRow_ = std::max(0, rowOf(highest));
    starts_.assign(std::size_t(rows_) * std::size_t(bands_) + 2, 0);
    tallestIn_.assign(std::size_t(rows_ + 1) * std::size_t(bands_), 0);
    for (const WallPiece& piece : found_) {
        const std::size_t slot = slotOf(piece);
        ++starts_[slot + 2];
        tallestIn_[slot] = std::max(tallestIn_[slot], piece.highRise);
    }
    tallest_ = tallestIn_;
    for (std::size_t i = 2; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    sorted_.resize(found_.size());
    bounds_.resize(found_.size());
    for (const WallPiece& piece : found_) put(piece, starts_[slotOf(piece) + 1]++);
    for (std::size_t i = std::size_t(rows_) * std::size_t(bands_); i-- > 0;)
        tallest_[i] = std::max(tallest_[i], tallest_[i + std::size_t(bands_)]);
}

void BinWalls::put(const WallPiece& piece, std::size_t at) {
    sorted_[at] = piece;
    const auto [lowQ, highQ] = std::minmax(piece.lowQ, piece.highQ);
    bounds_.set(at, float(lowQ - tile_.lowQ), float(highQ - tile_.lowQ),
                float(double(piece.highAlong) - tile_.lowAlong), piece.rise);
}

BinWalls::Bands BinWalls::bandsOf(double lowQ, double highQ) const {
    return {std::clamp(int(std::floor(lowQ / bandWidth)) - 1 - firstBand_, 0, bands_),
            std::clamp(int(std::floor(highQ / bandWidth)) + 1 - firstBand_, 0, bands_)};
}

BinWalls::Bands BinWalls::bandsOf(double lowQ, double highQ, double highestAlong, int row) const {
    const double aside = spread_ * std::max(0.0, highestAlong - this->highestAlong(row) + 2 * rowDepth);
    return bandsOf(lowQ - aside, highQ + aside);
}

BinWalls::Range BinWalls::rangeOf(int row, const Bands& bands) const {
    const std::size_t slot = std::size_t(row) * std::size_t(bands_);
    return {starts_[slot + std::size_t(bands.first)], starts_[slot + std::size_t(bands.end)]};
}

std::span<const WallPiece> BinWalls::pieces(int row, const Bands& bands) const {
    const auto [first, end] = rangeOf(row, bands);
    return std::span(sorted_).subspan(first, end - first);
}

float BinWalls::highest(const std::vector<float>& rises, int row, const Bands& bands) const {
    const float* of = rises.data() + std::size_t(row) * std::size_t(bands_);
    return *std::max_element(of + bands.first, of + bands.end);
}

}  // namespace noonmark
