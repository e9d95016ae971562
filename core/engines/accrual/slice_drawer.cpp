#include "core/engines/accrual/slice_drawer.h"

#include <algorithm>
#include <glm/common.hpp>

namespace noonmark {

namespace {

double computeArea(const MapPolygon& polygon) {
    double twice = 0;
    for (std::size_t i = 2; i < polygon.corners; ++i) {
        const glm::dvec2 a = polygon.place[i - 1] - polygon.place[0], b = polygon.place[i] - polygon.place[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

bool offMap(const MapPolygon& polygon, const DepthSlice& slice) {
    glm::dvec2 low = polygon.place[0], high = low;
    for (std::size_t i = 1; i < polygon.corners; ++i) {
        low = glm::min(low, polygon.place[i]);
        high = glm::max(high, polygon.place[i]);
    }
    return high.x < 0 || high.y < 0 || low.x > slice.columns || low.y > slice.rows;
}

void turnRound(MapPolygon& polygon) {
    std::reverse(polygon.place.begin(), polygon.place.begin() + std::ptrdiff_t(polygon.corners));
    std::reverse(polygon.depth.begin(), polygon.depth.begin() + std::ptrdiff_t(polygon.corners));
}

void addCorner(MapPolygon& polygon, glm::dvec3 texel, double depth) {
    polygon.place[polygon.corners] = {texel.x / texel.z, texel.y / texel.z};
    // On the warped map, depth / q is linear, not depth.
    polygon.depth[polygon.corners++] = depth / texel.z;
}

}  // namespace

SliceCost SliceDrawer::draw(const IntervalCasters& casters, const MapFrame& frame, glm::dvec2 shear,
                            CasterSide side, DepthSlice& slice) {
    slice.clear();
    seen_.resize(casters.points.size());
    for (std::size_t i = 0; i < seen_.size(); ++i)
        seen_[i] = {frame.homogeneous(casters.points[i], shear), casters.points[i].z};
    SliceCost cost;
    for (const CasterFace& face : casters.faces) drawFace(face, side, slice, cost);
    return cost;
}

void SliceDrawer::drawFace(const CasterFace& face, CasterSide side, DepthSlice& slice, SliceCost& cost) {
    MapPolygon polygon;
    for (std::size_t i = 0; i < face.corners; ++i) {
        const Seen& here = seen_[face.corner[i]];
        const Seen& next = seen_[face.corner[i + 1 == face.corners ? 0 : i + 1]];
        const bool before = here.texel.z >= MapFrame::minQ, nextBefore = next.texel.z >= MapFrame::minQ;
        if (before) addCorner(polygon, here.texel, here.depth);
        if (before == nextBefore) continue;
        const double share = (MapFrame::minQ - here.texel.z) / (next.texel.z - here.texel.z);
        addCorner(polygon, glm::mix(here.texel, next.texel, share), glm::mix(here.depth, next.depth, share));
    }
    if (polygon.corners < 3 || offMap(polygon, slice)) return;
    const double area = computeArea(polygon);
    if (!face.twoSided && (area > 0) != (side == CasterSide::towardsSun)) return;
    if (area < 0) turnRound(polygon);
    ++cost.faces;
    cost.rows += std::uint64_t(pen_.draw(polygon, slice));
}

}  // namespace noonmark
