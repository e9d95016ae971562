#include "render/view/section_box.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

constexpr double farthestM = 1e7;
constexpr double sharedM = 0.01;  // surfaces in a side of the box belong to it, as in the shaders

double& coordinate(SectionBox& box, SectionSide side) {
    return side.high ? box.highM[side.axis] : box.lowM[side.axis];
}

}  // namespace

SectionBox makeSectionAround(const ViewBounds& bounds) {
    constexpr double marginM = 2;
    return {glm::dvec3(bounds.box.low.x, bounds.box.low.y, bounds.groundM) - marginM,
            glm::dvec3(bounds.box.high.x, bounds.box.high.y, bounds.topM) + marginM};
}

std::optional<SectionBox> repairSection(SectionBox box) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(box.lowM[axis]) <= farthestM && std::abs(box.highM[axis]) <= farthestM))
            return std::nullopt;
        box.highM[axis] = std::max(box.highM[axis], box.lowM[axis] + minSectionM);
    }
    return box;
}

double positionOf(const SectionBox& box, SectionSide side) {
    return side.high ? box.highM[side.axis] : box.lowM[side.axis];
}

glm::dvec3 centreOf(const SectionBox& box, SectionSide side) {
    glm::dvec3 centre = (box.lowM + box.highM) / 2.0;
    centre[side.axis] = positionOf(box, side);
    return centre;
}

SectionBox moveSide(SectionBox box, SectionSide side, double toM) {
    const double other = positionOf(box, {side.axis, !side.high});
    const double clear = side.high ? std::max(toM, other + minSectionM) : std::min(toM, other - minSectionM);
    coordinate(box, side) = std::clamp(clear, -farthestM, farthestM);
    return box;
}

std::optional<RaySpan> findSpan(const SectionBox& box, const ViewRay& ray) {
    RaySpan span{0, 1e30};
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.lowM[axis] - sharedM - ray.origin[axis];
        const double high = box.highM[axis] + sharedM - ray.origin[axis];
        if (ray.direction[axis] == 0) {
            if (low > 0 || high < 0) return std::nullopt;
            continue;
        }
        const auto [near, far] = std::minmax({low / ray.direction[axis], high / ray.direction[axis]});
        span.fromM = std::max(span.fromM, near);
        span.toM = std::min(span.toM, far);
    }
    return span.fromM <= span.toM ? std::optional(span) : std::nullopt;
}

bool contains(const SectionBox& box, const glm::dvec3& point) {
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] < box.lowM[axis] - sharedM || point[axis] > box.highM[axis] + sharedM) return false;
    return true;
}

}  // namespace noonmark
