#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/engines/projected/filling/bit_raster.h"
#include "core/engines/projected/filling/step_registers.h"

namespace noonmark {

/// Rows of a convex shape at eight steps, in bit rasters of some rows of a grid. Inlined into a kernel
/// (registers.h) for registers of each width; all widths give the same bits, in every band.
namespace convex_fill {

// Rows are resolved to 1e-7 of a cell; `farEast` is beyond any grid.
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
            atOrBeyond(shape.highest.y, band.first, band.end),
            atOrBeyond(shape.lowest.x, layout.firstColumn(), layout.columns),
            atOrBeyond(shape.highest.x, layout.firstColumn(), layout.columns)};
}

/// The span of a row at each step.
template <class Register>
struct StepSpans {
    EightDoubles<Register> west, east;

    [[gnu::always_inline]] inline void boundBy(const StepLines& lines, double row) {
        for (std::size_t i = 0; i < lines.westerns; ++i) west = most(west, at(lines.western[i], row));
        for (std::size_t i = 0; i < lines.easterns; ++i) east = least(east, at(lines.eastern[i], row));
    }

private:
    [[gnu::always_inline]] static inline EightDoubles<Register> at(const StepLine& line, double row) {
        return EightDoubles<Register>(line.atRow0) + EightDoubles<Register>(line.slope) * row;
    }
};

/// Follows a chain upwards, row by row.
class ChainWalk {
public:
    explicit ChainWalk(const EdgeChain& chain) : chain_(chain) {}

    template <class Register, class Bound>
    [[gnu::always_inline]] inline void forEdgesAt(double row, const Bound& bound) {
        while (next_ < chain_.count && chain_.edges[next_]->high + chain_.mostUp < row) ++next_;
        for (std::size_t i = next_; i < chain_.count && chain_.edges[i]->low + chain_.leastUp <= row; ++i) {
            const RingEdge& edge = *chain_.edges[i];
            const EightDoubles<Register> x(chain_.at.x), y(chain_.at.y);
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
    template <class Register>
    [[gnu::always_inline]] inline Reach(const StepShape& shape, const Extent& extent, Register)
        : extent_(extent) {
        using Doubles = EightDoubles<Register>;
        const double first = extent.bottom, last = extent.top - 1, rows = std::max(1.0, last - first);
        const StepLine &western = shape.sides.western[0], &eastern = shape.sides.eastern[0];
        if (shape.sides.westerns == 0) return;
        const Doubles westAt0(western.atRow0), eastAt0(eastern.atRow0), westSlope(western.slope),
            eastSlope(eastern.slope);
        const double west = leastOf(westAt0 + westSlope * first),
                     toWest = leastOf(westAt0 + westSlope * last),
                     east = -leastOf(-(eastAt0 + eastSlope * first)),
                     toEast = -leastOf(-(eastAt0 + eastSlope * last));
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
    template <class Register>
    [[gnu::always_inline]] inline bool allSet(const StepWords* words, std::ptrdiff_t stride) const {
        const std::uint64_t from = ~std::uint64_t{0} << unsigned(west & 63),
                            to = ~std::uint64_t{0} >> unsigned(63 - ((east - 1) & 63));
        const int first = firstWord(), last = lastWord();
        WordsOf<Register> lit{};
        addLit<Register>(words[first * stride], first == last ? from & to : from, lit);
        for (int word = first + 1; word < last; ++word)
            addLit<Register>(words[word * stride], ~std::uint64_t{0}, lit);
        if (last > first) addLit<Register>(words[last * stride], to, lit);
        return !anySetIn<Register>(lit);
    }

private:
    template <class Register>
    [[gnu::always_inline]] static inline void addLit(const StepWords& word, std::uint64_t among,
                                                     WordsOf<Register>& lit) {
        const EightWords<Register> steps(word);
        for (const auto& part : steps.part) lit |= ~part & among;
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
template <class Register>
[[gnu::always_inline]] inline void endRows(const StepShape& shape, double row, StepSpans<Register>& spans) {
    const EightDoubles<Register> high(shape.high), low(shape.low);
    spans.east = least(spans.east, (high - row) * steep);
    spans.east = least(spans.east, (row - low) * steep + farEast);
}

/// The first cell of each step's span, or the first one after it, and the bits of a word from there on.
template <class Register>
struct FirstCells {
    HalfIntsOf<Register> column;

    // Rounded up, as count - floor(count - x).
    [[gnu::always_inline]] inline FirstCells(const DoublesOf<Register>& position, int columns) {
        const DoublesOf<Register> left = double(columns) - position;
        column = columns - __builtin_convertvector(left, HalfIntsOf<Register>);
    }
    // A shift by 64 is composed of two shifts. One condition per selection: the compiler splits others into
    // scalar operations (GCC 12).
    [[gnu::always_inline]] inline void bitsFrom(int word, WordsOf<Register>& bits) const {
        const HalfIntsOf<Register> zero{}, full = 64 - zero;
        HalfIntsOf<Register> bit = column - 64 * word;
        bit = bit > zero ? bit : zero;
        bit = bit < full ? bit : full;
        const auto by = WordsOf<Register>(__builtin_convertvector(bit, LongsOf<Register>)), half = by >> 1;
        bits = ~WordsOf<Register>{} << half << (by - half);
    }
};

template <class Register>
[[gnu::always_inline]] inline void setSpans(const StepSpans<Register>& spans, const RowCells& cells,
                                            int columns, StepWords* words, std::ptrdiff_t stride) {
    using Part = WordsOf<Register>;
    for (std::size_t i = 0; i < partsOfSteps<Register>; ++i) {
        const FirstCells<Register> first(spans.west.part[i], columns), end(spans.east.part[i], columns);
        for (int word = cells.firstWord(); word <= cells.lastWord(); ++word) {
            Part from, beyond;
            first.bitsFrom(cells.origin + word, from);
            end.bitsFrom(cells.origin + word, beyond);
            reinterpret_cast<Part&>(words[word * stride].words[i * stepsAPart<Register>]) |= from & ~beyond;
        }
    }
}

}  // namespace convex_fill

/// Fills a shape at eight steps into their bit rasters over some rows of a grid: the eight words of the same
/// cells are contiguous, in the order of the layout. The centre of cell (column, row) is at (column, row) and
/// is filled by the same half-open rule as everywhere (core/city/footprints/crossing.h), up to rounding in
/// double.
///
/// The shape lies within 10^8 of the raster; parts outside the raster are clipped. Rows whose reachable cells
/// are already set are skipped. Returns the number of rows visited. Cost: 10 ns, and up to 10 ns per row.
template <class Register>
[[gnu::always_inline]] inline int fillShape(const StepShape& shape, const BitLayout& layout,
                                            const RowBand& band, std::span<std::uint64_t> rasters) {
    using namespace convex_fill;
    using Doubles = EightDoubles<Register>;
    const Extent extent = extentOf(shape, layout, band);
    if (extent.empty()) return 0;
    auto* words =
        reinterpret_cast<StepWords*>(&rasters[std::size_t(extent.bottom - band.first) * stepsTogether]);
    const Doubles none(layout.firstColumn()), all(layout.columns);
    const SteadyRows steady(shape);
    ChainWalk farWest(shape.western[0]), nearWest(shape.western[1]), farEast(shape.eastern[0]),
        nearEast(shape.eastern[1]);
    Reach reach(shape, extent, Register{});
    for (int row = extent.bottom; row < extent.top; ++row, ++words, reach.moveUp()) {
        const RowCells cells{reach.west(), reach.east(), layout.firstWord};
        if (cells.west >= cells.east || cells.template allSet<Register>(words, layout.rows)) continue;
        const double y = row;
        StepSpans<Register> spans{none, all};
        spans.boundBy(shape.sides, y);
        const auto western = [&](const Doubles& at) __attribute__((always_inline)) {
            spans.west = most(spans.west, at);
        };
        const auto eastern = [&](const Doubles& at) __attribute__((always_inline)) {
            spans.east = least(spans.east, at);
        };
        farWest.forEdgesAt<Register>(y, western);
        nearWest.forEdgesAt<Register>(y, western);
        farEast.forEdgesAt<Register>(y, eastern);
        nearEast.forEdgesAt<Register>(y, eastern);
        if (y < steady.first || y > steady.last) endRows(shape, y, spans);
        spans.west = least(all, spans.west);
        spans.east = most(none, spans.east);
        setSpans(spans, cells, layout.columns, words, layout.rows);
    }
    return extent.top - extent.bottom;
}

}  // namespace noonmark
