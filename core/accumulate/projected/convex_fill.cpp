#include "core/accumulate/projected/convex_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {

using Doubles8 = double __attribute__((vector_size(64), may_alias));
using Longs8 = std::int64_t __attribute__((vector_size(64), may_alias));
using Words8 = std::uint64_t __attribute__((vector_size(64), may_alias, aligned(8)));
using Ints8 = std::int32_t __attribute__((vector_size(32), may_alias));

constexpr std::size_t mostEdges = 64;

/// The line of an edge: where it crosses a row, counted from a polygon's lowest row on.
struct Line {
    double column;
    double slope;
};

/// Edges on one side of a polygon that cross a row.
struct Side {
    std::array<Line, mostEdges> lines;
    int count = 0;
    void add(const Line& line) { lines[std::size_t(count++)] = line; }
};

/// The rows and columns of a raster that may lie in a polygon.
struct Extent {
    int bottom = 0, top = 0;  ///< rows [bottom, top)
    int west = 0, east = 0;   ///< columns [west, east)
    [[nodiscard]] bool empty() const { return bottom >= top || west >= east; }
    [[nodiscard]] int firstWord() const { return west >> 6; }
    [[nodiscard]] int lastWord() const { return (east - 1) >> 6; }
};

int atOrBeyond(double position, int count) {
    return int(std::ceil(std::clamp(position, 0.0, double(count))));
}

Extent extentOf(std::span<const glm::dvec2> polygon, const BitLayout& layout) {
    glm::dvec2 low = polygon[0], high = polygon[0];
    for (const glm::dvec2 point : polygon) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    return {atOrBeyond(low.y, layout.rows), atOrBeyond(high.y, layout.rows),
            atOrBeyond(low.x, layout.columns), atOrBeyond(high.x, layout.columns)};
}

/// Outside a convex polygon the lines of its edges run outside: a row enters where it has crossed all western
/// ones, and leaves at the first eastern one.
struct Sides {
    Side western, eastern;

    Sides(std::span<const glm::dvec2> polygon, int bottom) {
        for (std::size_t i = 0; i < polygon.size(); ++i)
            add(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1], bottom);
    }

private:
    // The same line whichever way the edge runs, so that neighbours leave no gap and share no cell.
    void add(glm::dvec2 a, glm::dvec2 b, int bottom) {
        const bool isEastern = b.y > a.y;
        if (!isEastern) std::swap(a, b);
        if (std::ceil(a.y) >= b.y) return;  // between two rows
        const double slope = (b.x - a.x) / (b.y - a.y);
        (isEastern ? eastern : western).add({a.x + (bottom - a.y) * slope, slope});
    }
};

NOONMARK_EVERY_ISA bool allSet(const std::uint64_t* words, int count, std::ptrdiff_t stride, int columns) {
    for (int column = 0; column < columns; ++column, words += stride) {
        Words8 all = ~Words8{};
        int k = 0;
        for (; k + 8 <= count; k += 8) all &= *reinterpret_cast<const Words8*>(words + k);
        std::uint64_t every = ~std::uint64_t{0};
        for (; k < count; ++k) every &= words[k];
        for (int lane = 0; lane < 8; ++lane) every &= all[lane];
        if (every != ~std::uint64_t{0}) return false;
    }
    return true;
}

// Words that no row of these eight reaches need not be looked at.
inline void narrow(const Longs8& first, const Longs8& end, int& firstWord, int& lastWord) {
    std::int64_t west = first[0], east = end[0];
    for (int lane = 1; lane < 8; ++lane) {
        west = std::min<std::int64_t>(west, first[lane]);
        east = std::max<std::int64_t>(east, end[lane]);
    }
    firstWord = std::max(firstWord, int(west >> 6));
    lastWord = std::min(lastWord, int((east - 1) >> 6));
}

// Eight rows at a time. Columns are rounded up as count - floor(count - x); shifts by 64 are made of two. One
// condition a choice: the compiler takes others apart lane by lane (GCC 12).
NOONMARK_EVERY_ISA void fillRows(const Sides& sides, int rows, int columns, int firstWord, int lastWord,
                                 std::uint64_t* words, std::ptrdiff_t stride) {
    const Doubles8 none{}, all = double(columns) - none;
    const Longs8 zero{}, full = 64 - zero;
    const Words8 ones = ~Words8{};
    for (int row = 0; row < rows; row += 8) {
        const Doubles8 y = Doubles8{0, 1, 2, 3, 4, 5, 6, 7} + double(row);
        Doubles8 west = none, east = all;
        for (int i = 0; i < sides.western.count; ++i) {
            const Line& line = sides.western.lines[std::size_t(i)];
            const Doubles8 at = line.column + y * line.slope;
            west = at > west ? at : west;
        }
        for (int i = 0; i < sides.eastern.count; ++i) {
            const Line& line = sides.eastern.lines[std::size_t(i)];
            const Doubles8 at = line.column + y * line.slope;
            east = at < east ? at : east;
        }
        west = west < all ? west : all;
        east = east > none ? east : none;
        const Longs8 first =
            columns - __builtin_convertvector(__builtin_convertvector(all - west, Ints8), Longs8);
        Longs8 end = columns - __builtin_convertvector(__builtin_convertvector(all - east, Ints8), Longs8);
        end = y < double(rows) ? end : zero;
        int westWord = firstWord, eastWord = lastWord;
        if (eastWord - westWord > 1) narrow(first, end, westWord, eastWord);
        for (int word = westWord; word <= eastWord; ++word) {
            Longs8 low = first - 64 * word, high = end - 64 * word;
            low = low > zero ? low : zero;
            low = low < full ? low : full;
            high = high > zero ? high : zero;
            high = high < full ? high : full;
            const Longs8 halfLow = low >> 1, halfHigh = high >> 1;
            const Words8 from = ones << Words8(halfLow) << Words8(low - halfLow);
            const Words8 beyond = ones << Words8(halfHigh) << Words8(high - halfHigh);
            auto& eight = *reinterpret_cast<Words8*>(words + (word - firstWord) * stride + row);
            eight |= from & ~beyond;
        }
    }
}

}  // namespace

int fillConvex(std::span<const glm::dvec2> polygon, const BitLayout& layout,
               std::span<std::uint64_t> raster) {
    if (polygon.size() > mostEdges) {  // cut along a chord: both sides are convex
        std::vector<glm::dvec2> rest(polygon.begin() + mostEdges - 1, polygon.end());
        rest.push_back(polygon[0]);
        return fillConvex(polygon.first(mostEdges), layout, raster) + fillConvex(rest, layout, raster);
    }
    const Extent extent = extentOf(polygon, layout);
    if (extent.empty()) return 0;
    const int rows = extent.top - extent.bottom;
    std::uint64_t* words = &raster[layout.word(extent.firstWord() * 64, extent.bottom)];
    if (allSet(words, rows, layout.stride, extent.lastWord() - extent.firstWord() + 1)) return 0;
    fillRows(Sides(polygon, extent.bottom), rows, layout.columns, extent.firstWord(), extent.lastWord(),
             words, layout.stride);
    return rows;
}

}  // namespace noonmark
