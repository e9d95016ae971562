#include "core/engines/points/horizons/range_bounds.h"

#include <algorithm>

namespace noonmark {

int BinRanges::around(int first, int bins) {
    first %= SunBins::count;
    for (int size = 0; size < sizes; ++size)
        if (first % step + bins <= step << unsigned(size)) return size * starts + first / step;
    return all;
}

RangeBounds::RangeBounds(const BinHorizon& horizon) {
    constexpr int starts = BinRanges::starts;
    for (int start = 0; start < starts; ++start) {
        const auto first = std::size_t(start * BinRanges::step), at = std::size_t(start);
        low[at] = high[at] = horizon.tan[first];
        for (std::size_t bin = first; bin < first + BinRanges::step; ++bin) {
            low[at] = std::min(low[at], horizon.tan[bin]);
            high[at] = std::max(high[at], horizon.topTan(bin));
        }
    }
    for (int size = 1; size < BinRanges::sizes; ++size)  // of two windows of half the size
        for (int start = 0; start < starts; ++start) {
            const int halves = (size - 1) * starts;
            const auto a = std::size_t(halves + start);
            const auto b = std::size_t(halves + (start + (1 << unsigned(size - 1))) % starts);
            const auto at = std::size_t(size * starts + start);
            low[at] = std::min(low[a], low[b]);
            high[at] = std::max(high[a], high[b]);
        }
    low[BinRanges::all] = *std::min_element(low.begin(), low.begin() + starts);
    high[BinRanges::all] = *std::max_element(high.begin(), high.begin() + starts);
}

}  // namespace noonmark
