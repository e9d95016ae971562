#include "core/engines/projected/masks/caster_reach.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/engines/projected/casters/caster_shaping.h"
#include "core/engines/projected/casters/cell_coordinates.h"
#include "core/engines/projected/casters/shadow_offsets.h"

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

}  // namespace

CasterReach::CasterReach(const SunSteps& sun, double cellM, std::size_t first, std::size_t end)
    : throws_(computeOffsets(sun, cellM, first, end)) {
    end = std::min(end, sun.steps.size());
    glm::dvec2 sum{};
    for (std::size_t step = first; step < end; ++step) {
        const glm::dvec2 thrown = shadowOffsetInCells(glm::dvec3(sun.steps[step].direction), cellM);
        if (const double length = glm::length(thrown); length > 0) sum += thrown / length;
    }
    if (const double length = glm::length(sum); length > 0) across_ = glm::dvec2(-sum.y, sum.x) / length;
    for (std::size_t step = first; step < end; ++step) {
        const glm::dvec2 thrown = shadowOffsetInCells(glm::dvec3(sun.steps[step].direction), cellM);
        leastAcross_ = std::min(leastAcross_, glm::dot(thrown, across_));
        mostAcross_ = std::max(mostAcross_, glm::dot(thrown, across_));
    }
}

void CasterReach::aimAt(glm::dvec2 low, glm::dvec2 high) {
    low_ = low - marginCells;
    high_ = high + marginCells;
    const Range range = extentAlong(low_, high_, across_);
    lowAcross_ = range.low;
    highAcross_ = range.high;
}

bool CasterReach::touches(const ShadowCaster& caster) const {
    const SweptBox box = computeSweptBox(caster, throws_);
    if (box.low.x > high_.x || box.high.x < low_.x || box.low.y > high_.y || box.high.y < low_.y)
        return false;
    const Range range = extentAlong(caster.low, caster.high, across_);
    const double top = caster.topM;
    return range.low + std::min(leastAcross_ * top, -mostAcross_ * behindWallM) <= highAcross_ &&
           range.high + std::max(mostAcross_ * top, -leastAcross_ * behindWallM) >= lowAcross_;
}

}  // namespace noonmark
