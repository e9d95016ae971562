#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace noonmark {

/// Spans of a convex polygon on a raster whose cell (column, row) has its centre at that position. Half-open:
/// a centre on a western or southern edge is inside, on an eastern or northern one outside. An edge gives the
/// same columns for the polygons on both its sides, so neighbours leave no gap and share no cell.
namespace convex_spans {

// Columns as 32.32 fixed point: a row costs one addition, and the error after a thousand rows is below 1e-6
// of a cell.
using Fixed = std::int64_t;
constexpr double fixedOne = 4294967296.0;

inline Fixed toFixedPoint(double columns) { return Fixed(std::clamp(columns, -1e9, 1e9) * fixedOne); }
inline int firstColumnAtOrBeyond(Fixed x, int columns) {
    return int(std::clamp<Fixed>((x + Fixed(fixedOne) - 1) >> 32, 0, columns));
}
inline int firstRowAtOrBeyond(double y, int rows) { return int(std::ceil(std::clamp(y, 0.0, double(rows)))); }

/// One side of the polygon, followed upwards edge by edge.
class Side {
public:
    Side(std::span<const glm::dvec2> polygon, std::size_t lowest, bool counterClockwise)
        : polygon_(polygon), at_(lowest), forward_(counterClockwise), edgesLeft_(polygon.size()) {}

    /// Advances to the edge that crosses `row`; false above the last.
    bool reach(int row, int rows) {
        while (end_ <= row) {
            if (edgesLeft_-- == 0) return false;
            const glm::dvec2 a = polygon_[at_];
            at_ = next();
            const glm::dvec2 b = polygon_[at_];
            if (b.y > a.y) start(a, b, row, rows);
        }
        return true;
    }

    [[nodiscard]] int end() const { return end_; }
    [[nodiscard]] Fixed x() const { return x_; }
    [[nodiscard]] Fixed slope() const { return slope_; }
    void moveUp(int rows) { x_ += slope_ * rows; }

private:
    [[nodiscard]] std::size_t next() const {
        if (forward_) return at_ + 1 == polygon_.size() ? 0 : at_ + 1;
        return at_ == 0 ? polygon_.size() - 1 : at_ - 1;
    }

    void start(glm::dvec2 a, glm::dvec2 b, int row, int rows) {
        end_ = firstRowAtOrBeyond(b.y, rows);
        const double slope = (b.x - a.x) / (b.y - a.y);
        slope_ = toFixedPoint(slope);
        x_ = toFixedPoint(a.x + (double(row) - a.y) * slope);
    }

    std::span<const glm::dvec2> polygon_;
    std::size_t at_;
    bool forward_;
    std::size_t edgesLeft_;
    int end_ = -1;  // first row after the edge
    Fixed x_ = 0;   // at the current row
    Fixed slope_ = 0;
};

}  // namespace convex_spans

/// Calls `span(row, first, end)` for every row of the counter-clockwise polygon with a cell in it, 0 <= first
/// < end <= columns, upwards. Returns the number of rows that the polygon crosses.
template <class Span>
int forEachSpan(std::span<const glm::dvec2> polygon, int columns, int rows, const Span& span) {
    using namespace convex_spans;
    const auto [low, high] = std::ranges::minmax_element(polygon, {}, &glm::dvec2::y);
    const std::size_t lowest = std::size_t(low - polygon.begin());
    Side left(polygon, lowest, false), right(polygon, lowest, true);
    const int bottom = firstRowAtOrBeyond(low->y, rows), top = firstRowAtOrBeyond(high->y, rows);
    int row = bottom;
    while (row < top && left.reach(row, rows) && right.reach(row, rows)) {
        const int stop = std::min({left.end(), right.end(), top});
        for (; row < stop; ++row, left.moveUp(1), right.moveUp(1)) {
            const int first = firstColumnAtOrBeyond(left.x(), columns);
            const int end = firstColumnAtOrBeyond(right.x(), columns);
            if (first < end) span(row, first, end);
        }
    }
    return row - bottom;
}

/// The depth map of one step: 32-bit depths, larger is closer to the sun. Row-major, `stride` floats per row
/// (more than there are columns, so that vectors may extend past the end).
struct DepthSlice {
    static constexpr float empty = -1e30F;  ///< value of texels without a face

    DepthSlice(int columnCount, int rowCount);
    void clear();

    int columns = 0;
    int rows = 0;
    std::uint32_t stride = 0;
    std::vector<float> depth;
};

/// Corners of a face in the coordinates of a map.
struct MapPolygon {
    static constexpr std::size_t maximum = 5;  ///< four, and one more if it is clipped
    std::array<glm::dvec2, maximum> place{};   ///< texels, counter-clockwise
    std::array<double, maximum> depth{};
    std::size_t corners = 0;
};

/// A section of a row, with the depth at its first texel.
struct DepthSpan {
    std::uint32_t at = 0;  ///< index of its first texel in DepthSlice::depth
    std::int32_t count = 0;
    float depth = 0;
};

/// How a face's depth continues along its rows: by `gradient` per texel, clamped to `low` and `high`.
struct RowDepth {
    float gradient = 0, low = 0, high = 0;
};

/// Draws polygons into slices; reuses its buffer. One per thread.
class DepthPainter {
public:
    /// Raises the slice where the polygon is closer to the sun. Texels are chosen by the half-open rule of
    /// depth_slice.h. Returns the number of rows drawn.
    int draw(const MapPolygon& polygon, DepthSlice& slice);

private:
    std::vector<DepthSpan> spans_;
};

}  // namespace noonmark
