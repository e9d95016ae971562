#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/depths/depth_slice_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <cmath>

#include "core/engines/depths/depth_slice.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

// Texels raised at a time, whatever the width of a vector.
constexpr std::size_t together = 16;
using D = LanesUpTo<float, together>;
using V = hn::Vec<D>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(d), parts = together / lanes;

// Raises the first `left` texels of a vector.
HWY_INLINE void raise(V depth, int left, float* at) {
    const hn::RebindToSigned<D> di;
    const auto inside = hn::RebindMask(d, hn::Lt(hn::Iota(di, 0), hn::Set(di, left)));
    const V before = hn::LoadU(d, at);
    hn::StoreU(hn::IfThenElse(inside, hn::Max(depth, before), before), d, at);
}

HWY_INLINE void raiseSpan(const DepthSpan& span, const RowDepth& along, float* at) {
    const V lowest = hn::Set(d, along.low), highest = hn::Set(d, along.high),
            gradient = hn::Set(d, along.gradient), further = hn::Set(d, float(together) * along.gradient);
    V depth[parts];
    for (std::size_t i = 0; i < parts; ++i)
        depth[i] = hn::Add(hn::Set(d, span.depth), hn::Mul(gradient, hn::Iota(d, float(i * lanes))));
    for (int left = span.count; left > 0; left -= int(together), at += together) {
        HWY_UNROLL(4)
        for (std::size_t i = 0; i < parts; ++i) {
            if (left <= int(i * lanes)) break;
            raise(hn::Min(highest, hn::Max(lowest, depth[i])), left - int(i * lanes), at + i * lanes);
            depth[i] = hn::Add(depth[i], further);
        }
    }
}

}  // namespace

void raiseSpans(std::span<const DepthSpan> spans, const RowDepth& along, float* depths) {
    for (const DepthSpan& span : spans) raiseSpan(span, along, depths + span.at);
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

namespace {

/// Depth as a linear function over a face, clamped to `low` and `high` so that rounding on a face seen
/// edge-on has no effect.
struct DepthPlane {
    glm::dvec2 foot{};
    double depth = 0;  ///< at `foot`
    glm::dvec2 gradient{};
    float low = 0;
    float high = 0;

    [[nodiscard]] float at(double x, double y) const {
        return float(depth + gradient.x * (x - foot.x) + gradient.y * (y - foot.y));
    }
};

// Newell's normal: a sum over all edges, accurate also for long thin faces.
DepthPlane planeOf(const MapPolygon& polygon) {
    double nx = 0, ny = 0, nz = 0;
    for (std::size_t i = 0; i < polygon.corners; ++i) {
        const std::size_t j = i + 1 == polygon.corners ? 0 : i + 1;
        const glm::dvec2 a = polygon.place[i] - polygon.place[0], b = polygon.place[j] - polygon.place[0];
        const double da = polygon.depth[i] - polygon.depth[0], db = polygon.depth[j] - polygon.depth[0];
        nx += a.y * db - da * b.y;
        ny += da * b.x - a.x * db;
        nz += a.x * b.y - a.y * b.x;
    }
    const auto [low, high] = std::ranges::minmax(std::span(polygon.depth).first(polygon.corners));
    DepthPlane plane{polygon.place[0], polygon.depth[0], {}, float(low), float(high)};
    if (nz > 0) plane.gradient = {-nx / nz, -ny / nz};
    return plane;
}

}  // namespace

DepthSlice::DepthSlice(int columnCount, int rowCount)
    : columns(columnCount),
      rows(rowCount),
      stride((std::uint32_t(columnCount) + 31U) / 16U * 16U),
      depth(std::size_t(stride) * std::size_t(rowCount), empty) {}

void DepthSlice::clear() { std::ranges::fill(depth, empty); }

NOONMARK_KERNEL(raiseSpans);
int DepthPainter::draw(const MapPolygon& polygon, DepthSlice& slice) {
    const DepthPlane plane = planeOf(polygon);
    spans_.clear();
    const int rows =
        forEachSpan(std::span(polygon.place).first(polygon.corners), slice.columns, slice.rows,
                    [&](int row, int first, int end) {
                        spans_.push_back({std::uint32_t(row) * slice.stride + std::uint32_t(first),
                                          end - first, plane.at(first, row)});
                    });
    NOONMARK_CALL(raiseSpans)
    (spans_, {float(plane.gradient.x), plane.low, plane.high}, slice.depth.data());
    return rows;
}

}  // namespace noonmark
#endif
