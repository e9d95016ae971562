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

// The same of the face behind an edge; where it leans nobody is on it who is not below the edge.
float nearestOf(glm::vec3 outward) {
    constexpr float plumb = 1e-6F;
    return std::abs(outward.z) <= plumb && outward.x + outward.y > 0 ? -onTheWall : onTheWall;
}

}  // namespace

void BinWalls::find(const WallList& list, const Obstacles& obstacles, glm::dvec2 away,
                    const ShadowExtent& tile, double cellM, float lowestTan, const std::stop_token& stop) {
    const ShadowAxes axes(away);
    begin(axes, tile, cellM, lowestTan);
    for (const StandingPrism& prism : obstacles.prisms) addPrism(list, prism, axes);
    for (const StandingSolid& solid : obstacles.solids) addSolid(solid, axes, glm::vec2(away));
    if (obstacles.terrain != nullptr) addTerrain(*obstacles.terrain, list.terrainNumber, axes, away, stop);
    sort();
}

void BinWalls::begin(const ShadowAxes& axes, const ShadowExtent& tile, double cellM, float lowestTan) {
    found_.clear();
    outOfReach_ = 0;
    alongPerMetre_ = axes.alongPerDistance / cellM;
    lowestTan_ = double(lowestTan);
    tile_ = tile;
}

bool BinWalls::inReach(const ShadowExtent& extent, double reach) const {
    return extent.highQ > tile_.lowQ && extent.lowQ < tile_.highQ && extent.lowAlong <= tile_.highAlong &&
           extent.highAlong + reach >= tile_.lowAlong;
}

// How far an obstacle of this rise can shade, in cells along, is kept in reach_.
bool BinWalls::reachesTile(const ShadowAxes& axes, glm::dvec2 low, glm::dvec2 high, double rise) {
    reach_ = rise / lowestTan_ + 1;
    ShadowExtent extent;
    extent.addBox(axes, low, high);
    const bool reaches = inReach(extent, reach_);
    if (!reaches) ++outOfReach_;
    return reaches;
}

void BinWalls::addPrism(const WallList& list, const StandingPrism& prism, const ShadowAxes& axes) {
    const double rise = double(prism.topM) * alongPerMetre_;
    if (!reachesTile(axes, prism.low, prism.high, rise)) return;
    glm::dvec2 corner{};  // where the wall before ends, as a rule this one begins
    ShadowAxes::Point b = axes.from(corner);
    for (const StandingWall& wall : list.wallsOf(prism)) {
        const ShadowAxes::Point a = wall.a == corner ? b : axes.from(wall.a);
        b = axes.from(corner = wall.b);
        const bool facesAway = axes.mirrored() ? a.q < b.q : b.q < a.q;
        if (facesAway)
            addPieces({a, rise}, {b, rise}, {.nearest = nearestOf(wall), .building = prism.building});
    }
}

void BinWalls::addSolid(const StandingSolid& solid, const ShadowAxes& axes, glm::vec2 away) {
    if (!reachesTile(axes, solid.low, solid.high, double(solid.topM) * alongPerMetre_)) return;
    backLit_.clear();
    for (const glm::vec3 normal : solid.normals) backLit_.push_back(backLitBelow(normal, away));
    for (const SolidEdge& edge : solid.edges)
        if (edge.right == SolidEdge::noFace ||
            isOutline(backLit_[edge.left], backLit_[edge.right], float(lowestTan_)))
            addEdge(solid, edge, axes);
}

void BinWalls::addEdge(const StandingSolid& solid, const SolidEdge& edge, const ShadowAxes& axes) {
    const glm::dvec3 a = solid.vertices[edge.a], b = solid.vertices[edge.b];
    const bool leftIsBehind = edge.right == SolidEdge::noFace || backLit_[edge.left] > backLit_[edge.right];
    const glm::vec3 behind = solid.normals[leftIsBehind ? edge.left : edge.right];
    addPieces({axes.from(glm::dvec2(a)), a.z * alongPerMetre_},
              {axes.from(glm::dvec2(b)), b.z * alongPerMetre_},
              {.nearest = nearestOf(behind), .building = solid.building});
}

// Of all squares of the terrain; a receiver lies at the datum or above.
void BinWalls::addTerrain(const TerrainEdges& terrain, std::uint32_t number, const ShadowAxes& axes,
                          glm::dvec2 away, const std::stop_token& stop) {
    terrain.find(
        {.axes = axes, .away = away, .tile = tile_, .lowestTan = lowestTan_, .alongPerMetre = alongPerMetre_},
        edges_, stop);
    for (const TerrainEdges::Edge& edge : edges_) {
        const double rise = std::max(edge.aM, edge.bM) * alongPerMetre_;
        reach_ = rise / lowestTan_ + 1;
        if (rise > 0)
            addPieces({edge.a, edge.aM * alongPerMetre_}, {edge.b, edge.bM * alongPerMetre_},
                      {.nearest = onTheWall, .building = number});
    }
}

void BinWalls::addPieces(End a, End b, WallPiece piece) {
    if (b.at.q < a.at.q) std::swap(a, b);
    if (!(a.at.q < b.at.q) || !(std::max(a.rise, b.rise) > 0)) return;
    const double wide = b.at.q - a.at.q, deep = b.at.along - a.at.along;
    const double slope = deep / wide, riseSlope = a.rise == b.rise ? 0 : (b.rise - a.rise) / wide;
    const double parts = std::max(wide / bandWidth, std::abs(deep) / rowDepth);
    const int count = parts <= 1 ? 1 : int(std::ceil(parts));
    const auto cut = [&](int i) { return i == count ? b.at.q : a.at.q + wide * i / count; };
    piece.slope = float(slope);
    piece.riseSlope = float(riseSlope);
    for (int i = 0; i < count; ++i) {
        piece.lowQ = cut(i);
        piece.highQ = cut(i + 1);
        piece.along0 = a.at.along + slope * (piece.lowQ - a.at.q);
        const double other = i + 1 == count ? b.at.along : a.at.along + slope * (piece.highQ - a.at.q);
        const double rise = a.rise + riseSlope * (piece.lowQ - a.at.q),
                     otherRise = a.rise + riseSlope * (piece.highQ - a.at.q);
        piece.highAlong = float(std::max(piece.along0, other));
        piece.rise = float(rise);
        piece.perRise = 1 / piece.rise;
        piece.highRise = float(std::max(rise, otherRise));
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
    bounds_.set(at, float(piece.lowQ - tile_.lowQ), float(piece.highQ - tile_.lowQ),
                float(double(piece.highAlong) - tile_.lowAlong), piece.rise);
}

BinWalls::Bands BinWalls::bandsOf(double lowQ, double highQ) const {
    return {std::clamp(int(std::floor(lowQ / bandWidth)) - 1 - firstBand_, 0, bands_),
            std::clamp(int(std::floor(highQ / bandWidth)) + 1 - firstBand_, 0, bands_)};
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
