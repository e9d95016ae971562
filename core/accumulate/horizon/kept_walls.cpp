#include "core/accumulate/horizon/kept_walls.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <unordered_set>

namespace noonmark {

namespace {

using Buildings = std::vector<std::shared_ptr<const Building>>;

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
    xs_.clear();
    ys_.clear();
    radii_.clear();
    for (const StandingPrism& prism : list_.prisms) {
        const glm::dvec2 middle = (prism.low + prism.high) / 2.0;
        xs_.push_back(float(middle.x));
        ys_.push_back(float(middle.y));
        radii_.push_back(float(glm::length(prism.high - middle)) + 1);  // wide of rounding
    }
}

void KeptWalls::across(const ShadowAxes& axes, const ShadowExtent& extent,
                       std::vector<StandingPrism>& prisms) const {
    prisms.clear();
    const auto& alongs = axes.swapped ? xs_ : ys_;
    const auto& acrosses = axes.swapped ? ys_ : xs_;
    const auto tilt = float(axes.k * axes.sign), middle = float((extent.lowQ + extent.highQ) / 2),
               half = float((extent.highQ - extent.lowQ) / 2);
    // A circle reaches sqrt(1 + k^2) times its radius far in q.
    for (std::size_t i = 0; i < xs_.size(); ++i)
        if (std::abs(acrosses[i] - tilt * alongs[i] - middle) <= half + 1.5F * radii_[i])
            prisms.push_back(list_.prisms[i]);
}

}  // namespace noonmark
