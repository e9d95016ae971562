#include "core/accumulate/accrual/depth_slice.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/accumulate/horizon/lanes16.h"
#include "core/accumulate/projected/convex_spans.h"

namespace noonmark {

namespace {

constexpr Floats16 lanes{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr Ints16 counting{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// How depth changes over a face; between `low` and `high`, so that rounding on a face seen edge on goes
/// nowhere.
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

// Newell's normal: the sum over all edges, good for long thin faces too.
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

// Comparisons stand right before their choice: the compiler takes a stored one apart, lane by lane.
[[gnu::always_inline]] inline void raise(float* at, const Floats16& depth, int left) {
    Floats16 before;
    std::memcpy(&before, at, sizeof before);
    const Floats16 inside = counting < left ? depth : before;
    const Floats16 after = inside > before ? inside : before;
    std::memcpy(at, &after, sizeof after);
}

NOONMARK_EVERY_ISA
void raiseSpans(const DepthSpan* spans, std::size_t count, float gradient, float low, float high,
                float* depths) {
    const Floats16 lowest = Floats16{} + low, highest = Floats16{} + high;
    for (std::size_t i = 0; i < count; ++i) {
        float* at = depths + spans[i].at;
        Floats16 depth = spans[i].depth + gradient * lanes;
        for (int left = spans[i].count; left > 0; left -= 16, at += 16, depth += 16 * gradient) {
            Floats16 held = depth < lowest ? lowest : depth;
            held = held > highest ? highest : held;
            raise(at, held, left);
        }
    }
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
    raiseSpans(spans_.data(), spans_.size(), float(plane.gradient.x), plane.low, plane.high,
               slice.depth.data());
    return rows;
}

}  // namespace noonmark
