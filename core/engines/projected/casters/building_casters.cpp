#include "core/engines/projected/casters/building_casters.h"

#include <algorithm>
#include <numeric>

namespace noonmark {

namespace {

ShadowCasters placeCasters(std::vector<std::shared_ptr<const Building>> buildings, const Grid& grid) {
    City city;
    city.buildings = std::move(buildings);
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    return makeShadowCasters(city, all, grid);
}

}  // namespace

BuildingCasters::BuildingCasters(std::vector<std::shared_ptr<const Building>> buildings, const Grid& grid)
    : ends_(buildings.size()) {
    casters_ = placeCasters(std::move(buildings), grid);
    const auto buildingOf = [&](std::uint32_t caster) { return casters_.casters[caster].building; };
    order_.resize(casters_.casters.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::ranges::stable_sort(order_, {}, buildingOf);
    for (std::uint32_t i = 0; i < ends_.size(); ++i)
        ends_[i] = std::size_t(std::ranges::upper_bound(order_, i, {}, buildingOf) - order_.begin());
}

}  // namespace noonmark
