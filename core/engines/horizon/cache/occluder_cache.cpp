#include "core/engines/horizon/cache/occluder_cache.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace noonmark {

namespace {

/// Removes the items of these owners from `items` and returns them. `ownerOf`, one per item, and `owners`
/// ascend.
template <class T>
std::vector<T> removeAt(std::vector<T>& items, std::vector<std::uint64_t>& ownerOf,
                        std::span<const std::uint64_t> owners) {
    std::vector<T> taken;
    if (owners.empty()) return taken;
    auto kept = std::size_t(std::ranges::lower_bound(ownerOf, owners.front()) - ownerOf.begin());
    for (std::size_t i = kept; i < items.size(); ++i) {
        while (!owners.empty() && owners.front() < ownerOf[i]) owners = owners.subspan(1);
        if (!owners.empty() && owners.front() == ownerOf[i]) {
            taken.push_back(std::move(items[i]));
            continue;
        }
        if (kept != i) items[kept] = std::move(items[i]);
        ownerOf[kept++] = ownerOf[i];
    }
    items.resize(kept);
    ownerOf.resize(kept);
    return taken;
}

}  // namespace

std::size_t OverhangCache::reaching(const Grid& grid, double lowestTan,
                                    std::span<const std::uint64_t> but) const {
    const glm::dvec2 last(grid.columns, grid.rows);
    std::size_t size = 0;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        const OverhangShapes& shapes = shapes_[i];
        const glm::dvec2 apart = glm::max(glm::max(shapes.low - last, -shapes.high), glm::dvec2(0));
        const double reach = shapes.topM / (grid.cellM * lowestTan) + 2;
        if (glm::length(apart) <= reach && !std::ranges::binary_search(but, owners_[i]))
            size += shapes.size();
    }
    return size;
}

void OverhangCache::add(OverhangShapes shapes, std::uint64_t owner) {
    shapes_.push_back(std::move(shapes));
    owners_.push_back(owner);
}

std::vector<OverhangShapes> OverhangCache::remove(std::span<const std::uint64_t> owners) {
    return removeAt(shapes_, owners_, owners);
}

void OverhangCache::across(const ShadowAxes& axes, const ShadowExtent& extent, double lowestTan,
                           double alongPerMetre, OverhangList& list) const {
    list.clear();
    for (const OverhangShapes& shapes : shapes_) {
        ShadowExtent own;
        own.addBox(axes, shapes.low, shapes.high);
        const double reach = shapes.topM * alongPerMetre / lowestTan + 2;
        if (own.highQ < extent.lowQ || own.lowQ > extent.highQ || own.lowAlong > extent.highAlong ||
            own.highAlong + reach < extent.lowAlong)
            continue;
        list.push_back(&shapes);
    }
}

namespace {

/// A grid of squares over the centres of prisms: 128 cells per side, or more if that gives too many squares.
struct SquareGrid {
    explicit SquareGrid(std::span<const StandingPrism> prisms) {
        glm::dvec2 low(1e30), high(-1e30);
        for (const StandingPrism& prism : prisms) {
            low = glm::min(low, prism.low);
            high = glm::max(high, prism.high);
        }
        west = float(low.x);
        south = float(low.y);
        const double extent = std::max(high.x - low.x, high.y - low.y);
        side = float(std::max(128.0, extent / 512));
        columns = rows = std::size_t(extent / double(side)) + 2;
    }
    [[nodiscard]] std::size_t count() const { return columns * rows; }
    [[nodiscard]] std::size_t at(float x, float y) const {
        return std::size_t((y - south) / side) * columns + std::size_t((x - west) / side);
    }
    [[nodiscard]] float middleX(std::size_t at) const { return west + (float(at % columns) + 0.5F) * side; }
    [[nodiscard]] float middleY(std::size_t at) const {
        const std::size_t row = at / columns;
        return south + (float(row) + 0.5F) * side;
    }

    float west = 0, south = 0, side = 0;
    std::size_t columns = 0, rows = 0;
};

// Below all receivers. Rounded down to 64 m steps, so that it rarely changes when receivers are added or
// removed; heights relative to it are rounded, so another datum would change them.
double datumOf(const Receivers& receivers) {
    constexpr double levelM = 64;
    return std::floor(lowestGroundM(receivers) / levelM) * levelM;
}

}  // namespace

WallCache WallCache::of(const City& city, const Receivers& receivers) {
    WallCache walls(receivers.grid);
    walls.list_.datumM = datumOf(receivers);
    walls.terrain_ = city.terrain;
    if (city.terrain)
        walls.list_.terrain =
            std::make_shared<const TerrainEdges>(city.terrain, receivers.grid, walls.list_.datumM);
    const ChangedBuildings all = findChangedBuildings({}, city.buildings);
    walls.replace(all, walls.collectWalls(all.added), city.buildings);
    walls.firstOfLast_ = walls.next_;
    walls.rememberCounts(false);
    return walls;
}

bool WallCache::sameGround(const City& city, const Receivers& receivers) const {
    return city.terrain == terrain_ && datumOf(receivers) == list_.datumM;
}

Result<WallChange> WallCache::update(const City& city, double lowestTan) {
    const ChangedBuildings changed = findChangedBuildings(buildings_, city.buildings);
    OverhangCache coming;
    AddedWalls more = collectWalls(changed.added);
    for (const OverhangShapes& shapes : more.overhangs) coming.add(shapes, shapes.building);
    const std::size_t reaching =
        overhangs_.reaching(grid_, lowestTan, ownersOf(changed.removed)) + coming.reaching(grid_, lowestTan);
    if (const auto able = checkOverhangCount(reaching); !able) return tl::make_unexpected(able.error());
    return replace(changed, std::move(more), city.buildings);
}

WallCache::AddedWalls WallCache::collectWalls(const Buildings& buildings) const {
    AddedWalls coming{{.datumM = list_.datumM}, {}};
    OverhangParts parts;
    for (std::uint32_t i = 0; i < buildings.size(); ++i)
        addStandingWalls(*buildings[i], i, grid_, coming.list, parts);
    coming.overhangs = toOverhangShapes(parts, grid_, list_.datumM);
    return coming;
}

WallChange WallCache::replace(const ChangedBuildings& changed, AddedWalls more, const Buildings& now) {
    const Owners removed = ownersOf(changed.removed);
    compactWalls();
    const bool undoesLast = wereAddedLast(removed);
    for (const auto& building : changed.removed) forget(building.get(), removed);
    WallChange change{.removed = remove(removed), .added = {}, .undoesLast = undoesLast};
    rememberCounts(undoesLast);
    change.added = add(std::move(more.list), std::move(more.overhangs));
    firstOfLast_ = next_;
    for (const auto& building : changed.added) numbers_.emplace(building.get(), next_++);
    updateBuildings(buildings_, now, changed.first);
    return change;
}

// Called before additions: all current occluders count as present before the change.
void WallCache::rememberCounts(bool undoesLast) {
    solidsBefore_ = list_.solids.size();
    if (!undoesLast) updateCircles();
}

WallCache::Owners WallCache::ownersOf(const Buildings& buildings) const {
    Owners owners;
    for (const auto& building : buildings) {
        auto own = numbers_.equal_range(building.get()).first;
        while (std::ranges::find(owners, own->second) != owners.end()) ++own;
        owners.push_back(own->second);
    }
    std::ranges::sort(owners);
    return owners;
}

// Whether these are exactly the buildings added last.
bool WallCache::wereAddedLast(const Owners& owners) const {
    if (owners.size() != next_ - firstOfLast_) return false;
    return owners.empty() || owners.front() == firstOfLast_;
}

void WallCache::forget(const Building* building, const Owners& owners) {
    const auto [first, end] = numbers_.equal_range(building);
    for (auto own = first; own != end;)
        own = std::ranges::binary_search(owners, own->second) ? numbers_.erase(own) : std::next(own);
}

// Building numbers in `more` and `overhangs` are relative to next_.
WallSet WallCache::add(WallList more, std::vector<OverhangShapes> overhangs) {
    for (StandingPrism& prism : more.prisms) {
        prism.firstWall += std::uint32_t(list_.walls.size());
        owners_.push_back(next_ + prism.building);
    }
    for (const StandingSolid& solid : more.solids) solidOwners_.push_back(next_ + solid.building);
    for (const OverhangShapes& shapes : overhangs) overhangs_.add(shapes, next_ + shapes.building);
    list_.walls.insert(list_.walls.end(), more.walls.begin(), more.walls.end());
    wallsUsed_ += more.walls.size();
    list_.prisms.insert(list_.prisms.end(), more.prisms.begin(), more.prisms.end());
    list_.solids.insert(list_.solids.end(), more.solids.begin(), more.solids.end());
    return {std::move(more.prisms), std::move(more.solids), std::move(overhangs)};
}

WallSet WallCache::remove(const Owners& owners) {
    WallSet removed{removeAt(list_.prisms, owners_, owners), removeAt(list_.solids, solidOwners_, owners),
                    overhangs_.remove(owners)};
    for (const StandingPrism& prism : removed.prisms) wallsUsed_ -= prism.wallCount;
    return removed;
}

// Walls of removed prisms stay until they are half of all walls.
void WallCache::compactWalls() {
    if (list_.walls.size() <= 2 * wallsUsed_ + 1000) return;
    std::vector<StandingWall> walls;
    for (StandingPrism& prism : list_.prisms) {
        const auto of = list_.wallsOf(prism);
        prism.firstWall = std::uint32_t(walls.size());
        walls.insert(walls.end(), of.begin(), of.end());
    }
    list_.walls = std::move(walls);
}

void WallCache::updateCircles() {
    circles_.clear();
    for (const StandingPrism& prism : list_.prisms) {
        const glm::dvec2 middle = (prism.low + prism.high) / 2.0;
        circles_.push_back({float(middle.x), float(middle.y),
                            float(glm::length(prism.high - middle)) + 1});  // exceeds rounding
    }
    updateSquares();
}

// A counting sort.
void WallCache::updateSquares() {
    squares_.clear();
    order_.resize(circles_.size());
    if (circles_.empty()) return;
    const SquareGrid grid(list_.prisms);
    squares_.resize(grid.count() + 1);
    for (const Circle& circle : circles_) ++squares_[grid.at(circle.x, circle.y) + 1].end;
    for (std::size_t i = 1; i < squares_.size(); ++i)
        squares_[i].first = squares_[i].end += squares_[i - 1].end;
    for (std::uint32_t i = 0; i < circles_.size(); ++i) {
        const Circle& circle = circles_[i];
        const std::size_t at = grid.at(circle.x, circle.y);
        order_[squares_[at].end++] = i;
        Circle& around = squares_[at].around;
        // Half a diagonal is less than 0.75 of a side.
        around = {grid.middleX(at), grid.middleY(at),
                  std::max(around.radius, circle.radius + 0.75F * grid.side)};
    }
    std::erase_if(squares_, [](const Square& square) { return square.around.radius == 0; });
}

// In q a circle extends sqrt(1 + k^2) < 1.5 times its radius.
bool WallCache::Circle::reaches(float tilt, bool swapped, float middle, float half) const {
    const float across = swapped ? y : x, along = swapped ? x : y;
    return std::abs(across - tilt * along - middle) <= half + 1.5F * radius;
}

void WallCache::across(const ShadowAxes& axes, const ShadowExtent& extent,
                       std::vector<StandingPrism>& prisms) const {
    prisms.clear();
    const auto tilt = float(axes.k * axes.sign), middle = float((extent.lowQ + extent.highQ) / 2),
               half = float((extent.highQ - extent.lowQ) / 2);
    for (const Square& square : squares_) {
        if (!square.around.reaches(tilt, axes.swapped, middle, half)) continue;
        for (std::uint32_t i = square.first; i < square.end; ++i)
            if (circles_[order_[i]].reaches(tilt, axes.swapped, middle, half))
                prisms.push_back(list_.prisms[order_[i]]);
    }
}

}  // namespace noonmark
