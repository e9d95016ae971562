#include "app/gui/view/panel/visible_ground.h"

#include <array>

#include "core/city/footprints/repair_footprint.h"

namespace noonmark {

namespace {

constexpr int pixelsAlongSide = 24;

// Pixels along the four sides of the picture, in order.
std::vector<glm::dvec2> borderPixels(const ViewLens& lens) {
    const std::array<glm::dvec2, 4> corners{
        {{0, lens.heightPx}, {lens.widthPx, lens.heightPx}, {lens.widthPx, 0}, {0, 0}}};
    std::vector<glm::dvec2> pixels;
    for (std::size_t side = 0; side < 4; ++side)
        for (int i = 0; i < pixelsAlongSide; ++i)
            pixels.push_back(corners[side] +
                             (corners[(side + 1) % 4] - corners[side]) * (double(i) / pixelsAlongSide));
    return pixels;
}

// Sutherland-Hodgman clipping: the part of a ring on the inner side of one side of the box.
template <class Inside, class Cut>
RawRing clippedBy(const RawRing& ring, Inside inside, Cut cut) {
    RawRing clipped;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 from = ring[i];
        const glm::dvec2 to = ring[(i + 1) % ring.size()];
        if (inside(from)) clipped.push_back(from);
        if (inside(from) != inside(to)) clipped.push_back(cut(from, to));
    }
    return clipped;
}

RawRing clippedBy(const RawRing& ring, int axis, double border, double sign) {
    return clippedBy(
        ring, [=](glm::dvec2 p) { return sign * (p[axis] - border) >= 0; },
        [=](glm::dvec2 a, glm::dvec2 b) { return a + (b - a) * ((border - a[axis]) / (b[axis] - a[axis])); });
}

RawRing clippedTo(const Box2& box, RawRing ring) {
    for (int axis = 0; axis < 2; ++axis) {
        ring = clippedBy(ring, axis, double(box.low[axis]), 1);
        ring = clippedBy(ring, axis, double(box.high[axis]), -1);
    }
    return ring;
}

}  // namespace

Region visibleGround(const CameraPose& pose, const ViewLens& lens, const ViewBounds& bounds) {
    RawRing ring;
    for (const glm::dvec2 pixel : borderPixels(lens)) {
        ViewRay ray = makeRayThrough(pose, lens, pixel);
        // The ground may begin behind the eye of a parallel projection.
        if (pose.isParallel()) ray.origin -= 1e6 * ray.direction;
        // Rays above the horizon are lowered to meet the ground far outside any city.
        ray.direction.z = std::min(ray.direction.z, -1e-3);
        if (const auto hit = findPlaneHit(ray, pose.target.z)) ring.emplace_back(hit->x, hit->y);
    }
    const RawRing within = clippedTo(bounds.box, std::move(ring));
    if (within.size() < 3) return {};
    return {"the ground in view", repairFootprint({within}).pieces};
}

}  // namespace noonmark
