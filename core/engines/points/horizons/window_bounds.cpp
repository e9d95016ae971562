#include "core/engines/points/horizons/window_bounds.h"

#include <algorithm>

namespace noonmark {

int BinWindows::around(int first, int bins) {
    first %= SunBins::count;
    for (int size = 0; size < sizes; ++size)
        if (first % step + bins <= step << unsigned(size)) return size * starts + first / step;
    return all;
}

WindowBounds::WindowBounds(const BinHorizon& horizon) {
    constexpr int starts = BinWindows::starts;
    for (int start = 0; start < starts; ++start) {
        const auto first = std::size_t(start * BinWindows::step), at = std::size_t(start);
        low[at] = high[at] = horizon.tan[first];
        for (std::size_t bin = first; bin < first + BinWindows::step; ++bin) {
            low[at] = std::min(low[at], horizon.tan[bin]);
            high[at] = std::max(high[at], horizon.topTan(bin));
        }
    }
    for (int size = 1; size < BinWindows::sizes; ++size)  // of two windows of half the size
        for (int start = 0; start < starts; ++start) {
            const int halves = (size - 1) * starts;
            const auto a = std::size_t(halves + start);
            const auto b = std::size_t(halves + (start + (1 << unsigned(size - 1))) % starts);
            const auto at = std::size_t(size * starts + start);
            low[at] = std::min(low[a], low[b]);
            high[at] = std::max(high[a], high[b]);
        }
    low[BinWindows::all] = *std::min_element(low.begin(), low.begin() + starts);
    high[BinWindows::all] = *std::max_element(high.begin(), high.begin() + starts);
}

}  // namespace noonmark
