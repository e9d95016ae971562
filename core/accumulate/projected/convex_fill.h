#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/accumulate/projected/bit_raster.h"
#include "core/accumulate/projected/step_lanes.h"

namespace noonmark {

/// Rows of a convex shape at eight steps, in bit rasters of some rows of a grid. Inlined into the caller, so
/// that it is compiled for each of the caller's instruction sets; all give the same bits, in every band.
namespace convex_fill {

using Longs8 = std::int64_t __attribute__((vector_size(64), may_alias));
using Ints8 = std::int32_t __attribute__((vector_size(32), may_alias));

// Rows are told apart to 1e-7 of a cell; `farEast` is beyond any grid.
constexpr double steep = 1e16, farEast = 1e9;

/// The rows and columns of a raster that may lie in a shape.
struct Extent {
    int bottom = 0, top = 0;  ///< rows [bottom, top)
    int west = 0, east = 0;   ///< columns [west, east)
    [[nodiscard]] bool empty() const { return bottom >= top || west >= east; }
};

inline int atOrBeyond(double position, int low, int high) {
    const double inside = std::clamp(position, double(low), double(high));
    const int below = int(inside);
    return below + int(double(below) < inside);
}

inline Extent extentOf(const StepShape& shape, const BitLayout& layout, const RowBand& band) {
    return {atOrBeyond(shape.lowest.y, band.first, band.end),
            atOrBeyond(shape.highest.y, band.first, band.end), atOrBeyond(shape.lowest.x, 0, layout.columns),
            atOrBeyond(shape.highest.x, 0, layout.columns)};
}

/// The span of a row at each step.
struct StepSpans {
    StepDoubles west, east;
};

[[gnu::always_inline]] inline void boundBy(const StepLines& lines, double row, StepSpans& spans) {
    for (std::size_t i = 0; i < lines.westerns; ++i) {
        const StepDoubles at = lines.western[i].atRow0 + row * lines.western[i].slope;
        spans.west = at > spans.west ? at : spans.west;
    }
    for (std::size_t i = 0; i < lines.easterns; ++i) {
        const StepDoubles at = lines.eastern[i].atRow0 + row * lines.eastern[i].slope;
        spans.east = at < spans.east ? at : spans.east;
    }
}

/// Walks a chain with the rows, upwards.
class ChainWalk {
public:
    explicit ChainWalk(const EdgeChain& chain) : chain_(chain) {}

    template <class Bound>
    [[gnu::always_inline]] inline void forEdgesAt(double row, const Bound& bound) {
        while (next_ < chain_.count && chain_.edges[next_]->high + chain_.mostUp < row) ++next_;
        for (std::size_t i = next_; i < chain_.count && chain_.edges[i]->low + chain_.leastUp <= row; ++i) {
            const RingEdge& edge = *chain_.edges[i];
            const StepDoubles at = edge.atRow0 + (chain_.at.x - chain_.at.y * edge.slope) + row * edge.slope;
            bound(at);
        }
    }

private:
    const EdgeChain& chain_;
    std::size_t next_ = 0;
};

[[gnu::always_inline]] inline double leastOf(const StepDoubles& of) {
    StepDoubles at = of;
    const auto keep = [&](const StepDoubles& other) __attribute__((always_inline)) {
        at = at < other ? at : other;
    };
    keep(__builtin_shufflevector(at, at, 4, 5, 6, 7, 0, 1, 2, 3));
    keep(__builtin_shufflevector(at, at, 2, 3, 0, 1, 6, 7, 4, 5));
    keep(__builtin_shufflevector(at, at, 1, 0, 3, 2, 5, 4, 7, 6));
    return at[0];
}

/// Columns that hold a shape's spans at all steps, from row to row: where the lines of a side are outermost
/// at the first row and at the last, on the line between these places they are no farther out.
class Reach {
public:
    [[gnu::always_inline]] inline Reach(const StepShape& shape, const Extent& extent) : extent_(extent) {
        const double first = extent.bottom, last = extent.top - 1, rows = std::max(1.0, last - first);
        const StepLine &western = shape.sides.western[0], &eastern = shape.sides.eastern[0];
        if (shape.sides.westerns == 0) return;
        const double west = leastOf(western.atRow0 + first * western.slope),
                     toWest = leastOf(western.atRow0 + last * western.slope),
                     east = -leastOf(-(eastern.atRow0 + first * eastern.slope)),
                     toEast = -leastOf(-(eastern.atRow0 + last * eastern.slope));
        west_ = fixedFrom(west) - margin;
        east_ = fixedFrom(east) + margin;
        westStep_ = std::int64_t(double(fixedFrom(toWest) - margin - west_) / rows);
        eastStep_ = std::int64_t(double(fixedFrom(toEast) + margin - east_) / rows);
    }

    [[nodiscard]] int west() const { return std::max(extent_.west, int(west_ >> 32)); }
    [[nodiscard]] int east() const { return std::min(extent_.east, int(east_ >> 32) + 1); }
    void moveUp() {
        west_ += westStep_;
        east_ += eastStep_;
    }

private:
    static constexpr double one = 4294967296.0;                      // 32.32 fixed point
    static constexpr std::int64_t margin = std::int64_t(one) / 128;  // far above what rows round
    static std::int64_t fixedFrom(double columns) {
        return std::int64_t(std::clamp(columns, -1e9, 1e9) * one);
    }
    Extent extent_;
    std::int64_t west_ = std::int64_t(-1e9 * one), east_ = std::int64_t(1e9 * one), westStep_ = 0,
                 eastStep_ = 0;
};

/// Cells [west, east) of a row, in words; `words`: of its first one.
struct RowCells {
    int west, east;
    [[nodiscard]] int firstWord() const { return west >> 6; }
    [[nodiscard]] int lastWord() const { return (east - 1) >> 6; }

    // Whether all are set at all steps.
    [[gnu::always_inline]] inline bool allSet(const StepBits* words, std::ptrdiff_t stride) const {
        const std::uint64_t from = ~std::uint64_t{0} << unsigned(west & 63),
                            to = ~std::uint64_t{0} >> unsigned(63 - ((east - 1) & 63));
        const int first = firstWord(), last = lastWord();
        StepBits lit = ~words[first * stride] & (first == last ? from & to : from);
        for (int word = first + 1; word < last; ++word) lit |= ~words[word * stride];
        if (last > first) lit |= ~words[last * stride] & to;
        return !anySet(lit);
    }
};

/// Rows in which every step of a shape has a span: there its ends need not be looked at.
struct SteadyRows {
    double first = -1e30, last = 1e30;
    explicit SteadyRows(const StepShape& shape) {
        for (std::size_t k = 0; k < stepsTogether; ++k) {
            first = std::max(first, shape.low[k] + 1e-6);
            last = std::min(last, shape.high[k] - 1e-6);
        }
    }
};

// Off its rows a shape ends west of the grid: by products, since the compiler does least and most well.
[[gnu::always_inline]] inline void endRows(const StepShape& shape, double row, StepSpans& spans) {
    const StepDoubles below = (shape.high - row) * steep, above = (row - shape.low) * steep + farEast;
    spans.east = below < spans.east ? below : spans.east;
    spans.east = above < spans.east ? above : spans.east;
}

// Columns are rounded up as count - floor(count - x); shifts by 64 are made of two. One condition a choice:
// the compiler takes others apart lane by lane (GCC 12).
[[gnu::always_inline]] inline void setSpans(const StepSpans& spans, const RowCells& cells, int columns,
                                            StepBits* words, std::ptrdiff_t stride) {
    const StepDoubles all = double(columns) - StepDoubles{};
    const Longs8 zero{}, full = 64 - zero;
    const StepBits ones = ~StepBits{};
    const Longs8 first =
        columns - __builtin_convertvector(__builtin_convertvector(all - spans.west, Ints8), Longs8);
    const Longs8 end =
        columns - __builtin_convertvector(__builtin_convertvector(all - spans.east, Ints8), Longs8);
    for (int word = cells.firstWord(); word <= cells.lastWord(); ++word) {
        Longs8 low = first - 64 * word, high = end - 64 * word;
        low = low > zero ? low : zero;
        low = low < full ? low : full;
        high = high > zero ? high : zero;
        high = high < full ? high : full;
        const Longs8 halfLow = low >> 1, halfHigh = high >> 1;
        const StepBits from = ones << StepBits(halfLow) << StepBits(low - halfLow);
        const StepBits beyond = ones << StepBits(halfHigh) << StepBits(high - halfHigh);
        words[word * stride] |= from & ~beyond;
    }
}

}  // namespace convex_fill

/// Fills a shape at eight steps into their bit rasters over some rows of a grid: the eight words of the same
/// cells lie together, in the order of the layout. The centre of cell (column, row) is at (column, row), so
/// that it is filled by the same half-open rule as everywhere (core/city/crossing.h), to rounding in double.
///
/// The shape lies within 10^8 of the raster; what lies off it is clipped. Rows that are set already wherever
/// a step may reach are passed over. Returns the number of rows looked at. Cost: 10 ns, and up to 10 ns a
/// row.
[[gnu::always_inline]] inline int fillShape(const StepShape& shape, const BitLayout& layout,
                                            const RowBand& band, std::span<std::uint64_t> rasters) {
    using namespace convex_fill;
    const Extent extent = extentOf(shape, layout, band);
    if (extent.empty()) return 0;
    auto* words =
        reinterpret_cast<StepBits*>(&rasters[layout.word(0, extent.bottom - band.first) * stepsTogether]);
    const StepDoubles none{}, all = double(layout.columns) - none;
    const SteadyRows steady(shape);
    ChainWalk farWest(shape.western[0]), nearWest(shape.western[1]), farEast(shape.eastern[0]),
        nearEast(shape.eastern[1]);
    Reach reach(shape, extent);
    for (int row = extent.bottom; row < extent.top; ++row, ++words, reach.moveUp()) {
        const RowCells cells{reach.west(), reach.east()};
        if (cells.west >= cells.east || cells.allSet(words, layout.rows)) continue;
        const double y = row;
        StepSpans spans{none, all};
        boundBy(shape.sides, y, spans);
        const auto western = [&](const StepDoubles& at) __attribute__((always_inline)) {
            spans.west = at > spans.west ? at : spans.west;
        };
        const auto eastern = [&](const StepDoubles& at) __attribute__((always_inline)) {
            spans.east = at < spans.east ? at : spans.east;
        };
        farWest.forEdgesAt(y, western);
        nearWest.forEdgesAt(y, western);
        farEast.forEdgesAt(y, eastern);
        nearEast.forEdgesAt(y, eastern);
        if (y < steady.first || y > steady.last) endRows(shape, y, spans);
        spans.west = spans.west < all ? spans.west : all;
        spans.east = spans.east > none ? spans.east : none;
        setSpans(spans, cells, layout.columns, words, layout.rows);
    }
    return extent.top - extent.bottom;
}

}  // namespace noonmark
