#include "core/engines/accrual/depth_slice.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/engines/projected/filling/convex_spans.h"
#include "core/simd/registers.h"

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

/// Number of texels raised at a time, whatever the register width.
constexpr int together = 16;

// Raises the first `left` texels of a register. Each comparison directly precedes its selection, because the
// compiler splits a stored comparison into scalar operations.
template <class Register>
[[gnu::always_inline]] inline void raise(float* at, const FloatsOf<Register>& depth, int left) {
    IntsOf<Register> counting;
    count<Register>(counting);
    FloatsOf<Register> before;
    std::memcpy(&before, at, sizeof before);
    const FloatsOf<Register> inside = counting < left ? depth : before;
    const FloatsOf<Register> after = inside > before ? inside : before;
    std::memcpy(at, &after, sizeof after);
}

/// How a face's depth continues along its rows.
struct RowDepth {
    float gradient, low, high;
};

template <class Register>
[[gnu::always_inline]] inline void raiseSpan(const DepthSpan& span, const RowDepth& face, float* at) {
    using Floats = FloatsOf<Register>;
    constexpr int parts = together / lanesIn<Register>;
    const Floats lowest = Floats{} + face.low, highest = Floats{} + face.high;
    IntsOf<Register> counting;
    count<Register>(counting);
    Floats depth[parts];
    for (int part = 0; part < parts; ++part)
        depth[part] =
            span.depth + face.gradient * __builtin_convertvector(counting + part * lanesIn<Register>, Floats);
    for (int left = span.count; left > 0; left -= together, at += together)
        for (int part = 0; part < parts && left > part * lanesIn<Register>; ++part) {
            Floats held = depth[part] < lowest ? lowest : depth[part];
            held = held > highest ? highest : held;
            raise<Register>(at + part * lanesIn<Register>, held, left - part * lanesIn<Register>);
            depth[part] += together * face.gradient;
        }
}

void raiseSpans(std::span<const DepthSpan> spans, const RowDepth& face, float* depths) {
    runWithWidestRegisters([=](auto registers) __attribute__((always_inline)) {
        float* const first = depths;
        const RowDepth along = face;
        for (const DepthSpan& span : spans) raiseSpan<decltype(registers)>(span, along, first + span.at);
    });
}

}  // namespace

DepthSlice::DepthSlice(int columnCount, int rowCount)
    : columns(columnCount),
      rows(rowCount),
      stride((std::uint32_t(columnCount) + 31U) / 16U * 16U),
      depth(std::size_t(stride) * std::size_t(rowCount), empty) {}

void DepthSlice::clear() { std::ranges::fill(depth, empty); }

int DepthPen::draw(const MapPolygon& polygon, DepthSlice& slice) {
    const DepthPlane plane = planeOf(polygon);
    spans_.clear();
    const int rows =
        forEachSpan(std::span(polygon.place).first(polygon.corners), slice.columns, slice.rows,
                    [&](int row, int first, int end) {
                        spans_.push_back({std::uint32_t(row) * slice.stride + std::uint32_t(first),
                                          end - first, plane.at(first, row)});
                    });
    raiseSpans(spans_, {float(plane.gradient.x), plane.low, plane.high}, slice.depth.data());
    return rows;
}

}  // namespace noonmark
