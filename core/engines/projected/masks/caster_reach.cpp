#include "core/engines/projected/masks/caster_reach.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/engines/projected/casters/cell_coordinates.h"
#include "core/engines/projected/casters/shadow_offsets.h"
#include "core/engines/projected/filling/caster_fill.h"

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

// Inlined into the loop over casters, which runs some thousand times for each window and eight steps.
bool CasterReach::touches(const ShadowCaster& caster) const {
    const double top = caster.topM;
    const glm::dvec2 first(across_.x > 0 ? caster.low.x : caster.high.x,
                           across_.y > 0 ? caster.low.y : caster.high.y),
        last(across_.x > 0 ? caster.high.x : caster.low.x, across_.y > 0 ? caster.high.y : caster.low.y);
    if (glm::dot(first, across_) + std::min(leastAcross_ * top, -mostAcross_ * behindWallM) > highAcross_ ||
        glm::dot(last, across_) + std::max(mostAcross_ * top, -leastAcross_ * behindWallM) < lowAcross_)
        return false;
    // The bounds of computeSweptBox().
    const double bottom = caster.bottomM > 0 ? double(caster.bottomM) : -behindWallM;
    const auto meets = [&](double low, double high, double least, double most, double from, double to) {
        return low + std::min({least * bottom, most * bottom, least * top}) <= to &&
               high + std::max({least * bottom, most * bottom, most * top}) >= from;
    };
    return meets(caster.low.x, caster.high.x, throws_.low.x, throws_.high.x, low_.x, high_.x) &&
           meets(caster.low.y, caster.high.y, throws_.low.y, throws_.high.y, low_.y, high_.y);
}

}  // namespace noonmark
