#include "core/accumulate/projected/convex_fill.h"

#include <algorithm>
#include <cmath>

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

namespace {

using Longs8 = std::int64_t __attribute__((vector_size(64), may_alias));
using Words8 = std::uint64_t __attribute__((vector_size(64), may_alias, aligned(8)));
using Ints8 = std::int32_t __attribute__((vector_size(32), may_alias));

// Rows are told apart to 1e-7 of a cell; `farEast` is beyond any grid.
constexpr double steep = 1e16, farEast = 1e9;

/// The rows and columns of a raster that may lie in a shape.
struct Extent {
    int bottom = 0, top = 0;  ///< rows [bottom, top)
    int west = 0, east = 0;   ///< columns [west, east)
    [[nodiscard]] bool empty() const { return bottom >= top || west >= east; }
    [[nodiscard]] int firstWord() const { return west >> 6; }
    [[nodiscard]] int lastWord() const { return (east - 1) >> 6; }
};

int atOrBeyond(double position, int low, int high) {
    return int(std::ceil(std::clamp(position, double(low), double(high))));
}

Extent extentOf(const StepShape& shape, const BitLayout& layout, const RowBand& band) {
    return {atOrBeyond(shape.lowest.y, band.first, band.end),
            atOrBeyond(shape.highest.y, band.first, band.end), atOrBeyond(shape.lowest.x, 0, layout.columns),
            atOrBeyond(shape.highest.x, 0, layout.columns)};
}

template <std::size_t most>
[[gnu::always_inline]] inline void boundBy(const StepLines<most>& lines, double row, StepDoubles& west,
                                           StepDoubles& east) {
    for (std::size_t i = 0; i < lines.westerns; ++i) {
        const StepDoubles at = lines.western[i].atRow0 + row * lines.western[i].slope;
        west = at > west ? at : west;
    }
    for (std::size_t i = 0; i < lines.easterns; ++i) {
        const StepDoubles at = lines.eastern[i].atRow0 + row * lines.eastern[i].slope;
        east = at < east ? at : east;
    }
}

[[gnu::always_inline]] inline bool allSet(const Words8* words, int count, std::ptrdiff_t stride) {
    using Words4 = std::uint64_t __attribute__((vector_size(32)));
    using Words2 = std::uint64_t __attribute__((vector_size(16)));
    Words8 all = words[0];
    for (int i = 1; i < count; ++i) all &= words[i * stride];
    const Words4 four =
        __builtin_shufflevector(all, all, 0, 1, 2, 3) & __builtin_shufflevector(all, all, 4, 5, 6, 7);
    const Words2 two = __builtin_shufflevector(four, four, 0, 1) & __builtin_shufflevector(four, four, 2, 3);
    return (two[0] & two[1]) == ~std::uint64_t{0};
}

// Words that no step of this row reaches need not be looked at.
[[gnu::always_inline]] inline void narrow(StepDoubles west, StepDoubles east, int firstWord, int& word,
                                          int& lastWord) {
    const auto spread = [&](auto a, auto b) __attribute__((always_inline)) {
        west = west < a ? west : a;
        east = east > b ? east : b;
    };
    spread(__builtin_shufflevector(west, west, 4, 5, 6, 7, 0, 1, 2, 3),
           __builtin_shufflevector(east, east, 4, 5, 6, 7, 0, 1, 2, 3));
    spread(__builtin_shufflevector(west, west, 2, 3, 0, 1, 6, 7, 4, 5),
           __builtin_shufflevector(east, east, 2, 3, 0, 1, 6, 7, 4, 5));
    spread(__builtin_shufflevector(west, west, 1, 0, 3, 2, 5, 4, 7, 6),
           __builtin_shufflevector(east, east, 1, 0, 3, 2, 5, 4, 7, 6));
    word = std::max(word, (int(west[0]) >> 6) - firstWord);
    lastWord = std::min(lastWord, (int(east[0]) >> 6) - firstWord);
}

// `words`: of the first row and word. Columns are rounded up as count - floor(count - x); shifts by 64 are
// made of two. One condition a choice: the compiler takes others apart lane by lane (GCC 12).
NOONMARK_EVERY_ISA void fillRows(const StepShape& shape, const Extent& extent, int columns, Words8* words,
                                 std::ptrdiff_t stride) {
    const StepDoubles none{}, all = double(columns) - none;
    const Longs8 zero{}, full = 64 - zero;
    const Words8 ones = ~Words8{};
    const int firstWord = extent.firstWord(), wordCount = extent.lastWord() - firstWord + 1;
    for (int row = extent.bottom; row < extent.top; ++row, ++words) {
        if (allSet(words, wordCount, stride)) continue;
        const double y = row;
        StepDoubles west = none, east = all;
        boundBy(shape.sides, y, west, east);
        if (y >= shape.endLow && y <= shape.endHigh) boundBy(shape.ends, y, west, east);
        // Off its rows a shape ends west of the grid: by products, since the compiler does least and most
        // well.
        const StepDoubles below = (shape.high - y) * steep, above = (y - shape.low) * steep + farEast;
        east = below < east ? below : east;
        east = above < east ? above : east;
        west = west < all ? west : all;
        east = east > none ? east : none;
        const Longs8 first =
            columns - __builtin_convertvector(__builtin_convertvector(all - west, Ints8), Longs8);
        const Longs8 end =
            columns - __builtin_convertvector(__builtin_convertvector(all - east, Ints8), Longs8);
        int word = 0, lastWord = wordCount - 1;
        if (lastWord > 0) narrow(west, east, firstWord, word, lastWord);
        for (; word <= lastWord; ++word) {
            Longs8 low = first - 64 * (firstWord + word), high = end - 64 * (firstWord + word);
            low = low > zero ? low : zero;
            low = low < full ? low : full;
            high = high > zero ? high : zero;
            high = high < full ? high : full;
            const Longs8 halfLow = low >> 1, halfHigh = high >> 1;
            const Words8 from = ones << Words8(halfLow) << Words8(low - halfLow);
            const Words8 beyond = ones << Words8(halfHigh) << Words8(high - halfHigh);
            words[word * stride] |= from & ~beyond;
        }
    }
}

}  // namespace

int fillShape(const StepShape& shape, const BitLayout& layout, const RowBand& band,
              std::span<std::uint64_t> rasters) {
    const Extent extent = extentOf(shape, layout, band);
    if (extent.empty()) return 0;
    const std::size_t first = layout.word(extent.firstWord() * 64, extent.bottom - band.first);
    fillRows(shape, extent, layout.columns, reinterpret_cast<Words8*>(&rasters[first * stepsTogether]),
             layout.rows);
    return extent.top - extent.bottom;
}

}  // namespace noonmark
