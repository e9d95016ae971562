#pragma once

#include <array>

#include "core/engines/points/horizons/bin_horizon.h"

namespace noonmark {

/// Windows of neighbouring bins: 8, 16, ... 256 of them from every eighth bin on, and all. Index: first the
/// windows of 8 bins by their first bin, then those of 16, and so on; the last is of all bins.
struct BinRanges {
    static constexpr int step = 8, starts = SunBins::count / step, sizes = 6;
    static constexpr int all = starts * sizes, count = all + 1;

    /// The smallest window that holds `bins` of them from `first` on, which may lie beyond north.
    static int around(int first, int bins);
};

/// Bounds of a horizon in windows of bins: suns up to `low` are hidden, those above `high` are not.
struct RangeBounds {
    std::array<float, BinRanges::count> low, high;

    /// Some 2 us.
    explicit RangeBounds(const BinHorizon& horizon);
};

}  // namespace noonmark
