// Rows of a convex shape at eight steps, in bit rasters of some rows of a grid, for kernels; include after
// core/simd/kernel.h. All instruction sets give the same bits, in every band.
#if defined(NOONMARK_CONVEX_FILL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NOONMARK_CONVEX_FILL_INL_H
#undef NOONMARK_CONVEX_FILL_INL_H
#else
#define NOONMARK_CONVEX_FILL_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/engines/projected/filling/bit_raster.h"
#include "core/engines/projected/filling/step_registers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace convex_fill {

// Rows are resolved to 1e-7 of a cell; `farEast` is beyond any grid.
constexpr double steep = 1e16, farEast = 1e9;

/// The rows and columns of a raster that may lie in a shape.
struct Extent {
    int bottom = 0, top = 0;  ///< rows [bottom, top)
    int west = 0, east = 0;   ///< columns [west, east)
    [[nodiscard]] bool empty() const { return bottom >= top || west >= east; }
};

HWY_INLINE int atOrBeyond(double position, int low, int high) {
    const double inside = std::clamp(position, double(low), double(high));
    const int below = int(inside);
    return below + int(double(below) < inside);
}

HWY_INLINE Extent extentOf(const StepShape& shape, const BitLayout& layout, const RowBand& band) {
    return {atOrBeyond(shape.lowest.y, band.first, band.end),
            atOrBeyond(shape.highest.y, band.first, band.end),
            atOrBeyond(shape.lowest.x, layout.firstColumn(), layout.columns),
            atOrBeyond(shape.highest.x, layout.firstColumn(), layout.columns)};
}

/// The span of a row at each step.
struct StepSpans {
    EightDoubles west, east;

    HWY_INLINE void boundBy(const StepLines& lines, double row) {
        for (std::size_t i = 0; i < lines.westerns; ++i) west = maximum(west, at(lines.western[i], row));
        for (std::size_t i = 0; i < lines.easterns; ++i) east = minimum(east, at(lines.eastern[i], row));
    }

private:
    static HWY_INLINE EightDoubles at(const StepLine& line, double row) {
        return EightDoubles(line.atRow0) + EightDoubles(line.slope) * row;
    }
};

/// Follows a chain upwards, row by row.
class ChainWalk {
public:
    explicit ChainWalk(const EdgeChain& chain) : chain_(chain) {}

    template <class Bound>
    HWY_INLINE void forEdgesAt(double row, const Bound& bound) {
        while (next_ < chain_.count && chain_.edges[next_]->high + chain_.maxUp < row) ++next_;
        for (std::size_t i = next_; i < chain_.count && chain_.edges[i]->low + chain_.minUp <= row; ++i) {
            const RingEdge& edge = *chain_.edges[i];
            const EightDoubles x(chain_.at.x), y(chain_.at.y);
            bound(edge.atRow0 + (x - y * edge.slope) + row * edge.slope);
        }
    }

private:
    const EdgeChain& chain_;
    std::size_t next_ = 0;
};

/// Columns that contain a shape's spans at all steps, advanced from row to row. They run on a straight line
/// from the outermost bounds of the first row to those of the last, and no bound lies farther out in between.
class Reach {
public:
    HWY_INLINE Reach(const StepShape& shape, const Extent& extent) : extent_(extent) {
        const double first = extent.bottom, last = extent.top - 1, rows = std::max(1.0, last - first);
        const StepLine &western = shape.sides.western[0], &eastern = shape.sides.eastern[0];
        if (shape.sides.westerns == 0) return;
        const EightDoubles westAt0(western.atRow0), eastAt0(eastern.atRow0), westSlope(western.slope),
            eastSlope(eastern.slope);
        const double west = minimumOf(westAt0 + westSlope * first),
                     toWest = minimumOf(westAt0 + westSlope * last),
                     east = -minimumOf(-(eastAt0 + eastSlope * first)),
                     toEast = -minimumOf(-(eastAt0 + eastSlope * last));
        west_ = toFixedPoint(west) - margin;
        east_ = toFixedPoint(east) + margin;
        westStep_ = std::int64_t(double(toFixedPoint(toWest) - margin - west_) / rows);
        eastStep_ = std::int64_t(double(toFixedPoint(toEast) + margin - east_) / rows);
    }

    [[nodiscard]] int west() const { return std::max(extent_.west, int(west_ >> 32)); }
    [[nodiscard]] int east() const { return std::min(extent_.east, int(east_ >> 32) + 1); }
    void moveUp() {
        west_ += westStep_;
        east_ += eastStep_;
    }

private:
    static constexpr double one = 4294967296.0;                      // 32.32 fixed point
    static constexpr std::int64_t margin = std::int64_t(one) / 128;  // far above the rounding of rows
    static std::int64_t toFixedPoint(double columns) {
        return std::int64_t(std::clamp(columns, -1e9, 1e9) * one);
    }
    Extent extent_;
    std::int64_t west_ = std::int64_t(-1e9 * one), east_ = std::int64_t(1e9 * one), westStep_ = 0,
                 eastStep_ = 0;
};

/// The cells [west, east) of a row as words; `words` points to the row's first word, of which `origin` is the
/// number in the grid.
struct RowCells {
    int west, east, origin;
    [[nodiscard]] int firstWord() const { return (west >> 6) - origin; }
    [[nodiscard]] int lastWord() const { return ((east - 1) >> 6) - origin; }

    // Whether all cells are set at all steps.
    HWY_INLINE bool allSet(const StepWords* words, std::ptrdiff_t stride) const {
        const std::uint64_t from = ~std::uint64_t{0} << unsigned(west & 63),
                            to = ~std::uint64_t{0} >> unsigned(63 - ((east - 1) & 63));
        const int first = firstWord(), last = lastWord();
        auto lit = hn::Zero(stepBits);
        addLit(words[first * stride], first == last ? from & to : from, lit);
        for (int word = first + 1; word < last; ++word) addLit(words[word * stride], ~std::uint64_t{0}, lit);
        if (last > first) addLit(words[last * stride], to, lit);
        return !anySet(lit);
    }

private:
    static HWY_INLINE void addLit(const StepWords& word, std::uint64_t among, hn::Vec<StepBits>& lit) {
        for (const auto& part : EightWords(word).part)
            lit = hn::Or(lit, hn::AndNot(part, hn::Set(stepBits, among)));
    }
};

/// Rows in which every step of a shape has a span, so that the shape's ends need no test.
struct SteadyRows {
    double first = -1e30, last = 1e30;
    explicit SteadyRows(const StepShape& shape) {
        for (std::size_t k = 0; k < stepsTogether; ++k) {
            first = std::max(first, shape.low[k] + 1e-6);
            last = std::min(last, shape.high[k] - 1e-6);
        }
    }
};

// Outside its rows a shape ends west of the grid. Computed with products, because the compiler optimises min
// and max well.
HWY_INLINE void endRows(const StepShape& shape, double row, StepSpans& spans) {
    const EightDoubles high(shape.high), low(shape.low);
    spans.east = minimum(spans.east, (high - row) * steep);
    spans.east = minimum(spans.east, (row - low) * steep + farEast);
}

/// The first cell of each step's span, or the first one after it, and the bits of a word from there on.
class FirstCells {
public:
    // Rounded up, as count - floor(count - x). Whole numbers below 2^52 are the low bits of their sum with
    // 2^52.
    HWY_INLINE FirstCells(hn::Vec<StepNumbers> position, int columns) {
        const auto count = hn::Set(stepNumbers, double(columns)), large = hn::Set(stepNumbers, 0x1p52);
        const auto column = hn::Sub(count, hn::Floor(hn::Sub(count, position)));
        column_ = hn::Xor(hn::BitCast(stepBits, hn::Add(column, large)), hn::BitCast(stepBits, large));
    }
    // Computes with 32 bits, of which the upper half of each word remains 0.
    HWY_INLINE hn::Vec<StepBits> from(int word) const {
        const hn::RepartitionToNarrow<hn::RebindToSigned<StepBits>> halves;
        const auto low = [&](int number) HWY_ATTR {
            return hn::BitCast(halves, hn::Set(stepBits, std::uint64_t(number)));
        };
        const auto bit = hn::Sub(hn::BitCast(halves, column_), low(64 * word));
        const auto by = hn::Min(hn::Max(bit, hn::Zero(halves)), low(64));
        return shiftLeftUpTo64(stepBits, hn::Set(stepBits, ~std::uint64_t{0}), hn::BitCast(stepBits, by));
    }

private:
    hn::Vec<StepBits> column_;
};

HWY_INLINE void setSpans(const StepSpans& spans, const RowCells& cells, int columns, StepWords* words,
                         std::ptrdiff_t stride) {
    HWY_UNROLL(4)
    for (std::size_t i = 0; i < partsOfSteps; ++i) {
        const FirstCells first(spans.west.part[i], columns), end(spans.east.part[i], columns);
        for (int word = cells.firstWord(); word <= cells.lastWord(); ++word) {
            std::uint64_t* const at = words[word * stride].words + i * stepsAPart;
            const int column = cells.origin + word;  // of the grid, in words
            const auto inside = hn::AndNot(end.from(column), first.from(column));
            hn::Store(hn::Or(hn::Load(stepBits, at), inside), stepBits, at);
        }
    }
}

}  // namespace convex_fill

/// Fills a shape at eight steps into their bit rasters over some rows of a grid: the eight words of the same
/// cells are contiguous, in the order of the layout. The centre of cell (column, row) is at (column, row) and
/// is filled by the same half-open rule as everywhere (core/city/footprints/footprint.h), up to rounding in
/// double.
///
/// The shape lies within 10^8 of the raster; parts outside the raster are clipped. Rows whose reachable cells
/// are already set are skipped. Returns the number of rows visited. Cost: 10 ns, and up to 10 ns per row.
HWY_INLINE int fillShape(const StepShape& shape, const BitLayout& layout, const RowBand& band,
                         std::span<std::uint64_t> rasters) {
    using namespace convex_fill;
    const Extent extent = extentOf(shape, layout, band);
    if (extent.empty()) return 0;
    auto* words =
        reinterpret_cast<StepWords*>(&rasters[std::size_t(extent.bottom - band.first) * stepsTogether]);
    const EightDoubles none(layout.firstColumn()), all(layout.columns);
    const SteadyRows steady(shape);
    ChainWalk farWest(shape.western[0]), nearWest(shape.western[1]), farEast(shape.eastern[0]),
        nearEast(shape.eastern[1]);
    Reach reach(shape, extent);
    for (int row = extent.bottom; row < extent.top; ++row, ++words, reach.moveUp()) {
        const RowCells cells{reach.west(), reach.east(), layout.firstWord};
        if (cells.west >= cells.east || cells.allSet(words, layout.rows)) continue;
        const double y = row;
        StepSpans spans{none, all};
        spans.boundBy(shape.sides, y);
        const auto western = [&](const EightDoubles& at) HWY_ATTR { spans.west = maximum(spans.west, at); };
        const auto eastern = [&](const EightDoubles& at) HWY_ATTR { spans.east = minimum(spans.east, at); };
        farWest.forEdgesAt(y, western);
        nearWest.forEdgesAt(y, western);
        farEast.forEdgesAt(y, eastern);
        nearEast.forEdgesAt(y, eastern);
        if (y < steady.first || y > steady.last) endRows(shape, y, spans);
        spans.west = minimum(all, spans.west);
        spans.east = maximum(none, spans.east);
        setSpans(spans, cells, layout.columns, words, layout.rows);
    }
    return extent.top - extent.bottom;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
