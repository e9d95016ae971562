#include "core/engines/projected/masks/caster_groups.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>

namespace noonmark {

namespace {

constexpr double squareM = 100;

ShadowCaster encloseAll(const ShadowCasters& casters, std::span<const std::uint32_t> some) {
    ShadowCaster all;
    all.low = glm::dvec2(1e30);
    all.high = glm::dvec2(-1e30);
    for (const std::uint32_t i : some) {
        const ShadowCaster& caster = casters.casters[i];
        all.low = glm::min(all.low, caster.low);
        all.high = glm::max(all.high, caster.high);
        all.topM = std::max(all.topM, caster.topM);
    }
    return all;
}

}  // namespace

CasterGroups::CasterGroups(const ShadowCasters& casters, double cellM) : casters_(&casters) {
    const double side = squareM / cellM;
    std::map<std::pair<long long, long long>, std::vector<std::uint32_t>> squares;
    for (std::uint32_t i = 0; i < casters.casters.size(); ++i) {
        const glm::dvec2 middle = (casters.casters[i].low + casters.casters[i].high) / (2 * side);
        squares[{std::llround(middle.y), std::llround(middle.x)}].push_back(i);
    }
    for (const auto& [square, some] : squares) {
        enclosing_.add(encloseAll(casters, some));
        for (const std::uint32_t i : some) extents_.add(casters.casters[i]);
        order_.insert(order_.end(), some.begin(), some.end());
        ends_.push_back(order_.size());
    }
}

std::vector<std::uint32_t> CasterGroups::nearestFirst(glm::dvec2 low, glm::dvec2 high) const {
    std::vector<double> away;
    away.reserve(count());
    for (std::size_t group = 0; group < count(); ++group) {
        const glm::dvec2 from(enclosing_.lowX[group], enclosing_.lowY[group]),
            to(enclosing_.highX[group], enclosing_.highY[group]);
        away.push_back(glm::length(glm::max(glm::dvec2(0), glm::max(from - high, low - to))));
    }
    std::vector<std::uint32_t> order(count());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t group) { return away[group]; });
    return order;
}

}  // namespace noonmark
