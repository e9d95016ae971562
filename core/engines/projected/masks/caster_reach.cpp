#include "core/engines/projected/masks/caster_reach.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "core/engines/projected/casters/ring_lines.h"

namespace noonmark {

namespace {

constexpr double marginCells = 0.01;  // far above rounding

struct Range {
    double low, high;
};

// The extent of a box along a unit vector.
Range extentAlong(glm::dvec2 low, glm::dvec2 high, glm::dvec2 along) {
    const glm::dvec2 middle = (low + high) * 0.5, half = (high - low) * 0.5;
    const double centre = glm::dot(middle, along),
                 reach = half.x * std::abs(along.x) + half.y * std::abs(along.y);
    return {centre - reach, centre + reach};
}

// Offsets per metre, with that of heights between 0 and a little below the ground.
void include0(ReachLimits::Axis& axis) {
    axis.minimum = std::min(axis.minimum, 0.0);
    axis.maximum = std::max(axis.maximum, 0.0);
}

// The range, wider by what casts from a little below the ground.
void setRange(ReachLimits::Axis& axis, double low, double high) {
    const double below = behindWallM * std::max(-axis.minimum, axis.maximum);
    axis.low = low - below;
    axis.high = high + below;
}

}  // namespace

CasterReach::CasterReach(const SunSteps& sun, double cellM, std::size_t first, std::size_t end)
    : offsets_(computeOffsets(sun, cellM, first, end)) {
    end = std::min(end, sun.steps.size());
    limits_.x = {offsets_.low.x, offsets_.high.x, 0, 0};
    limits_.y = {offsets_.low.y, offsets_.high.y, 0, 0};
    glm::dvec2 sum{};
    for (std::size_t step = first; step < end; ++step) {
        const glm::dvec2 thrown = shadowOffsetInCells(glm::dvec3(sun.steps[step].direction), cellM);
        if (const double length = glm::length(thrown); length > 0) sum += thrown / length;
    }
    glm::dvec2& across = limits_.acrossUnit;
    if (const double length = glm::length(sum); length > 0) across = glm::dvec2(-sum.y, sum.x) / length;
    for (std::size_t step = first; step < end; ++step) {
        const glm::dvec2 thrown = shadowOffsetInCells(glm::dvec3(sun.steps[step].direction), cellM);
        limits_.across.minimum = std::min(limits_.across.minimum, glm::dot(thrown, across));
        limits_.across.maximum = std::max(limits_.across.maximum, glm::dot(thrown, across));
    }
    for (ReachLimits::Axis* axis : {&limits_.x, &limits_.y, &limits_.across}) include0(*axis);
}

void CasterReach::aimAt(glm::dvec2 low, glm::dvec2 high) {
    low -= marginCells;
    high += marginCells;
    setRange(limits_.x, low.x, high.x);
    setRange(limits_.y, low.y, high.y);
    const Range across = extentAlong(low, high, limits_.acrossUnit);
    setRange(limits_.across, across.low, across.high);
}

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
