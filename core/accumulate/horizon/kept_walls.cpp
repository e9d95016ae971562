#include "core/accumulate/horizon/kept_walls.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <unordered_set>

namespace noonmark {

namespace {

using Buildings = std::vector<std::shared_ptr<const Building>>;

/// Squares over some prisms' middles: 128 cells a side, or more where that makes too many.
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
    [[nodiscard]] float middleY(std::size_t at) const { return south + (float(at / columns) + 0.5F) * side; }

    float west = 0, south = 0, side = 0;
    std::size_t columns = 0, rows = 0;
};

/// Buildings of `from` that are not in `to`, each as often as it lacks there.
Buildings lacking(const Buildings& from, const Buildings& to) {
    const std::size_t common = std::min(from.size(), to.size());
    std::unordered_map<const Building*, int> there;
    for (std::size_t i = 0; i < to.size(); ++i)
        if (i >= common || from[i] != to[i]) ++there[to[i].get()];
    Buildings missing;
    for (std::size_t i = 0; i < from.size(); ++i)
        if ((i >= common || from[i] != to[i]) && there[from[i].get()]-- <= 0) missing.push_back(from[i]);
    return missing;
}

}  // namespace

Result<KeptWalls> KeptWalls::of(const City& city, const Grid& grid) {
    KeptWalls walls(grid);
    if (const auto change = walls.become(city); !change) return tl::make_unexpected(change.error());
    return walls;
}

Result<WallChange> KeptWalls::become(const City& city) {
    dropLostWalls();
    WallChange change;
    auto added = add(lacking(city.buildings, buildings_));
    if (!added) return tl::make_unexpected(added.error());
    change.added = std::move(*added);
    change.removed = remove(lacking(buildings_, city.buildings));
    buildings_ = city.buildings;
    noteCircles();
    return change;
}

Result<std::vector<StandingPrism>> KeptWalls::add(const Buildings& buildings) {
    WallList longer = {.walls = std::move(list_.walls)};
    const std::size_t walls = longer.walls.size();
    Result<void> state;
    std::vector<std::uint64_t> owners;
    for (const auto& building : buildings) {
        if (state) state = addStandingWalls(*building, 0, grid_, longer);
        owners.resize(longer.prisms.size(), next_ + (&building - buildings.data()));
    }
    if (!state) longer.walls.resize(walls);
    list_.walls = std::move(longer.walls);
    if (!state) return tl::make_unexpected(state.error());
    for (const auto& building : buildings) numbers_.emplace_back(building.get(), next_++);
    list_.prisms.insert(list_.prisms.end(), longer.prisms.begin(), longer.prisms.end());
    owners_.insert(owners_.end(), owners.begin(), owners.end());
    return std::move(longer.prisms);
}

std::vector<StandingPrism> KeptWalls::remove(const Buildings& buildings) {
    std::unordered_set<std::uint64_t> gone;
    for (const auto& building : buildings) {
        const auto number =
            std::ranges::find(numbers_, building.get(), [](const auto& n) { return n.first; });
        gone.insert(number->second);
        numbers_.erase(number);
    }
    std::vector<StandingPrism> removed;
    std::size_t kept = 0;
    for (std::size_t i = 0; !gone.empty() && i < owners_.size(); ++i) {
        if (gone.contains(owners_[i])) {
            removed.push_back(list_.prisms[i]);
            continue;
        }
        list_.prisms[kept] = list_.prisms[i];
        owners_[kept++] = owners_[i];
    }
    list_.prisms.resize(list_.prisms.size() - removed.size());
    owners_.resize(list_.prisms.size());
    return removed;
}

// Walls of what was removed stay until they are half of all.
void KeptWalls::dropLostWalls() {
    std::size_t used = 0;
    for (const StandingPrism& prism : list_.prisms) used += prism.wallCount;
    if (list_.walls.size() <= 2 * used + 1000) return;
    std::vector<StandingWall> walls;
    for (StandingPrism& prism : list_.prisms) {
        const auto of = list_.wallsOf(prism);
        prism.firstWall = std::uint32_t(walls.size());
        walls.insert(walls.end(), of.begin(), of.end());
    }
    list_.walls = std::move(walls);
}

void KeptWalls::noteCircles() {
    circles_.clear();
    for (const StandingPrism& prism : list_.prisms) {
        const glm::dvec2 middle = (prism.low + prism.high) / 2.0;
        circles_.push_back({float(middle.x), float(middle.y),
                            float(glm::length(prism.high - middle)) + 1});  // wide of rounding
    }
    noteSquares();
}

// By counting.
void KeptWalls::noteSquares() {
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

// A circle reaches sqrt(1 + k^2) times its radius far in q.
bool KeptWalls::Circle::reaches(float tilt, bool swapped, float middle, float half) const {
    const float across = swapped ? y : x, along = swapped ? x : y;
    return std::abs(across - tilt * along - middle) <= half + 1.5F * radius;
}

void KeptWalls::across(const ShadowAxes& axes, const ShadowExtent& extent,
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
