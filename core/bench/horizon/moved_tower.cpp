#include "core/bench/horizon/moved_tower.h"

#include <algorithm>
#include <cmath>

namespace noonmark::bench {

namespace {

constexpr float towerSideM = 40, towerHighM = 200;

City withTower(City city, glm::vec2 middle) {
    const glm::vec2 a = middle - towerSideM / 2, b = middle + towerSideM / 2;
    Building tower;
    tower.parts.push_back({.footprint = {{a, {b.x, a.y}, b, {a.x, b.y}}, {}}, .topM = towerHighM});
    city.buildings.push_back(std::make_shared<const Building>(std::move(tower)));
    return city;
}

bool same(const std::vector<float>& a, const std::vector<float>& b) {
    return std::ranges::equal(a, b,
                              [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

}  // namespace

Result<TowerPlace> placeTower(const BenchSite& site, float eastM, const Work& work) {
    const Region square = pickMiddleSquare(site.city, site.sideM);
    const Box2 box = bounds(square);
    TowerPlace place{withTower(site.city, (box.low + box.high) / 2.0F + glm::vec2(eastM, 0)), {}};
    auto receivers = placeReceiversOnGround(place.city, square, {}, work.stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    place.receivers = std::move(*receivers);
    return place;
}

bool haveSameMinutes(const ShadowField& a, const ShadowField& b) {
    return same(a.grossMin, b.grossMin) && same(a.continuousMin, b.continuousMin);
}

}  // namespace noonmark::bench
