#include "core/accumulate/horizon/line_walls.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

struct Extent {
    double lowQ = 1e300, highQ = -1e300, lowAlong = 1e300, highAlong = -1e300;
    void add(const ShearedTile::Point& point) {
        lowQ = std::min(lowQ, point.q);
        highQ = std::max(highQ, point.q);
        lowAlong = std::min(lowAlong, point.along);
        highAlong = std::max(highAlong, point.along);
    }
};

Extent extentOf(const StandingPrism& prism, const ShearedTile& tile) {
    Extent extent;
    for (const double x : {prism.low.x, prism.high.x})
        for (const double y : {prism.low.y, prism.high.y}) extent.add(tile.from({x, y}));
    return extent;
}

// Wide of the rounding of distances, cells.
constexpr float onTheWall = 1e-3F;

// A receiver on a wall counts as just east and north of it. So little behind that it is inside, it would be
// no receiver.
float nearestOf(const StandingWall& wall) {
    const glm::dvec2 edge = wall.b - wall.a;
    return edge.y > edge.x ? -onTheWall : onTheWall;
}

}  // namespace

void LineWalls::find(const WallList& list, const ShearedTile& tile, double cellM, float lowestTan) {
    walls_.clear();
    outOfReach_ = 0;
    alongPerMetre_ = tile.alongPerDistance() / cellM;
    lowestTan_ = lowestTan;
    lines_ = tile.lines();
    length_ = tile.length();
    for (const StandingPrism& prism : list.prisms) addPrism(list, prism, tile);
    // Near walls first: what they hide need not be looked at again.
    std::ranges::sort(walls_, std::ranges::greater{}, &LineWall::along0);
    sortIntoLines();
}

void LineWalls::addPrism(const WallList& list, const StandingPrism& prism, const ShearedTile& tile) {
    rise_ = float(prism.topM * alongPerMetre_);
    reach_ = rise_ / lowestTan_;
    const Extent extent = extentOf(prism, tile);
    if (extent.highQ <= 0 || extent.lowQ >= lines_ || extent.lowAlong > length_ ||
        extent.highAlong + double(reach_) < 0) {
        ++outOfReach_;
        return;
    }
    for (const StandingWall& wall : list.wallsOf(prism)) {
        const ShearedTile::Point a = tile.from(wall.a), b = tile.from(wall.b);
        const bool facesAway = tile.mirrored() ? a.q < b.q : b.q < a.q;
        if (!facesAway) continue;
        a.q < b.q ? addWall(a, b, nearestOf(wall)) : addWall(b, a, nearestOf(wall));
    }
}

void LineWalls::addWall(const ShearedTile::Point& a, const ShearedTile::Point& b, float nearest) {
    if (b.q <= 0 || a.q >= lines_) return;
    if (std::min(a.along, b.along) > length_ || std::max(a.along, b.along) + double(reach_) < 0) return;
    walls_.push_back({.lowQ = a.q,
                      .highQ = b.q,
                      .along0 = a.along,
                      .highAlong = std::max(a.along, b.along),
                      .slope = (b.along - a.along) / (b.q - a.q),
                      .rise = rise_,
                      .nearest = nearest,
                      .reach = reach_});
}

// By counting.
void LineWalls::sortIntoLines() {
    const auto firstLine = [](const LineWall& wall) { return std::size_t(std::max(0.0, wall.lowQ)); };
    const auto endLine = [&](const LineWall& wall) {
        return std::size_t(std::min(double(lines_), std::ceil(wall.highQ)));
    };
    starts_.assign(std::size_t(lines_) + 2, 0);
    for (const LineWall& wall : walls_)
        for (std::size_t line = firstLine(wall); line < endLine(wall); ++line) ++starts_[line + 2];
    for (std::size_t line = 2; line < starts_.size(); ++line) starts_[line] += starts_[line - 1];
    ids_.resize(starts_.back());
    for (std::uint32_t i = 0; i < walls_.size(); ++i)
        for (std::size_t line = firstLine(walls_[i]); line < endLine(walls_[i]); ++line)
            ids_[starts_[line + 1]++] = i;
}

}  // namespace noonmark
