#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/engines/points/hidden_altitudes.h"
#include "core/engines/points/horizons/bin_directions.h"
#include "core/engines/points/horizons/sun_bins.h"

namespace noonmark {

/// What one point sees of the sky, by bins of azimuth.
struct BinHorizon {
    BinTangents tan{};  ///< up to this tangent suns are hidden; infinite: all are
    /// What overhangs hide above that, of bin k: gaps[firstGap[k]] to gaps[firstGap[k + 1]], disjoint and
    /// ascending.
    std::array<std::uint32_t, SunBins::count + 1> firstGap{};
    std::vector<HiddenAltitudes> gaps;

    [[nodiscard]] bool hides(SunInBin sun) const {
        if (sun.tan <= tan[sun.bin]) return true;
        for (std::uint32_t i = firstGap[sun.bin]; i < firstGap[sun.bin + 1U]; ++i)
            if (sun.tan >= float(gaps[i].lowTan) && sun.tan <= float(gaps[i].highTan)) return true;
        return false;
    }
    void clearGaps() {
        firstGap.fill(0);
        gaps.clear();
    }
    /// Above this tangent nothing is hidden in the bin.
    [[nodiscard]] float topTan(std::size_t bin) const {
        if (firstGap[bin] == firstGap[bin + 1]) return tan[bin];
        return std::max(tan[bin], float(gaps[firstGap[bin + 1] - 1].highTan));
    }
};

/// Bounds of what one point sees at any azimuth of a bin.
struct HorizonBounds {
    BinHorizon touch;  ///< above its tangent no azimuth of the bin hides a sun; without gaps
    BinHorizon cover;  ///< what it hides every azimuth of the bin hides, but for slits between overhangs
};

}  // namespace noonmark
