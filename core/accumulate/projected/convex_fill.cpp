#include "core/accumulate/projected/convex_fill.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

int ceilToInt(double value) {
    const int whole = int(value);
    return whole + int(double(whole) < value);
}

// First column at or beyond the edge, for rows [first, end). Vectorised, with the instruction set picked at
// run time; no fused multiply-add, so that every processor gives the same columns.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
__attribute__((target_clones("avx512f", "avx2", "default")))
#endif
void walkEdge(double x, double y, double slope, int first, int end, int columns, std::int32_t* column) {
    const double most = columns;
    for (int row = first; row < end; ++row) {
        const double at = x + (double(row) - y) * slope;
        const double inside = at < 0 ? 0 : (at > most ? most : at);
        const int whole = int(inside);
        column[row] = whole + int(double(whole) < inside);
    }
}

int clampedCeil(double value, int limit) { return ceilToInt(std::clamp(value, -1.0, double(limit))); }

}  // namespace

ConvexFill::ConvexFill(const BitLayout& layout)
    : layout_(layout), left_(std::size_t(layout.rows)), right_(std::size_t(layout.rows)) {}

int ConvexFill::fill(std::span<const glm::dvec2> polygon, std::span<std::uint64_t> raster) {
    int low = layout_.rows, high = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        glm::dvec2 a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
        if (a.y == b.y) continue;
        const bool rising = a.y < b.y;  // the right side of a counter-clockwise polygon
        if (!rising) std::swap(a, b);
        const int first = std::max(0, clampedCeil(a.y, layout_.rows));
        const int end = std::max(0, clampedCeil(b.y, layout_.rows));
        if (first >= end) continue;
        walkEdge(a.x, a.y, (b.x - a.x) / (b.y - a.y), first, end, layout_.columns,
                 rising ? right_.data() : left_.data());
        low = std::min(low, first);
        high = std::max(high, end);
    }
    for (int row = low; row < high; ++row)
        if (left_[std::size_t(row)] < right_[std::size_t(row)])
            setRun(layout_.row(raster, row), left_[std::size_t(row)], right_[std::size_t(row)]);
    return std::max(0, high - low);
}

}  // namespace noonmark
