#include "core/engines/depths/slice_stack.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
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
    cost.rows += std::uint64_t(painter_.draw(polygon, slice));
}

namespace {
// A fifth of an hour. Groups are not smaller, because all threads wait for the slowest slice of each group.
constexpr int watchedSlices = 12;
}  // namespace

SliceStack::SliceStack(int columns, int rows)
    : workspaces_([columns, rows] {
          return Workspace{DepthSlice(columns, rows), {}, {}};
      }) {}

void SliceStack::shade(const IntervalCasters& casters, const MapFrame& frame, const SunInterval& interval,
                       CasterSide side, const LookUpStep& lookUp, std::span<ShadowMask> masks,
                       const std::stop_token& stop, const MaskWatcher* watcher) {
    const std::size_t words = (masks.size() + 63) / 64;
    shaded_.resize(std::size_t(interval.steps) * words);
    const int atOnce = watcher ? watchedSlices : interval.steps;
    for (int first = 0; first < interval.steps; first += atOnce) {
        const int end = std::min(first + atOnce, interval.steps);
        tbb::parallel_for(tbb::blocked_range<int>(first, end, 1), [&](const auto& range) {
            Workspace& workspace = workspaces_.local();
            for (int step = range.begin(); step < range.end() && !stop.stop_requested(); ++step) {
                const SliceCost cost = workspace.drawer.draw(casters, frame, frame.shearOf(interval.at(step)),
                                                             side, workspace.slice);
                workspace.cost.faces += cost.faces;
                workspace.cost.rows += cost.rows;
                lookUp(workspace.slice, step, std::span(shaded_).subspan(std::size_t(step) * words, words));
            }
        });
        if (stop.stop_requested()) return;
        const bool shown = end < interval.steps && watcher && watcher->wants();
        if (shown || end == interval.steps) takeMasks(end, words, masks);
        if (shown) watcher->show(end);
    }
}

SliceCost SliceStack::cost() const {
    SliceCost sum;
    for (const Workspace& workspace : workspaces_) {
        sum.faces += workspace.cost.faces;
        sum.rows += workspace.cost.rows;
    }
    return sum;
}

void SliceStack::takeMasks(int steps, std::size_t words, std::span<ShadowMask> masks) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, words, 256), [&](const auto& range) {
        for (std::size_t word = range.begin(); word < range.end(); ++word) {
            std::array<std::uint64_t, 64> bits{};
            for (std::size_t step = 0; step < std::size_t(steps); ++step)
                bits[step] = shaded_[step * words + word];
            transpose(bits);
            const auto here = masks.subspan(word * 64, std::min<std::size_t>(64, masks.size() - word * 64));
            std::copy_n(bits.begin(), here.size(), here.begin());
        }
    });
}

}  // namespace noonmark
