#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/engines/points/sky_obstacles.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The sun of a step as the sweep sees it.
struct SunInBin {
    std::uint16_t bin;  ///< of its azimuth, below SunBins::count
    float tan;          ///< tangent of its altitude
};
SunInBin binSun(const SunStep& step);

/// The suns of a period by azimuth, so that the minutes above an altitude are looked up and not counted.
/// Arrays for kernels.
struct SunBins {
    /// Bins of a quarter of a degree in the local frame, from +y, clockwise.
    static constexpr int count = 1440;
    static constexpr std::size_t blockSize = 16, months = 12;
    using Months = std::array<std::int32_t, months>;

    /// What belongs to one bin; one more at the end.
    struct Bin {
        std::uint32_t firstTan =
            0;  ///< in tans: ascending, then infinite to the end of a block, at least one
        std::uint32_t firstLast =
            0;  ///< in lastOfBlock: of each block of tans; infinite to the end of a block
        std::uint32_t firstRow = 0;  ///< in above
        std::uint32_t suns = 0;
        float highestTan = 0;  ///< tangent of the highest sun's altitude; 0 without suns
    };
    std::vector<Bin> bins;
    std::vector<float> tans, lastOfBlock;
    /// Row k of a bin: how many of its suns, by month, come after the first k; as many rows as suns and one
    /// more. A kernel may read `blockSize` entries from a row's beginning.
    std::vector<std::uint16_t> above;

    /// O(n log n), some 30 bytes a step.
    explicit SunBins(const SunSteps& sun);

    [[nodiscard]] bool empty(int bin) const { return bins[std::size_t(bin)].suns == 0; }
};

/// The middles of the bins of azimuth, and what is the highest sun in each.
struct BinDirections {
    /// A horizon above all suns of its bin: no obstacle matters there any more.
    static constexpr float always = std::numeric_limits<float>::infinity();
    /// Entries beyond the last bin, which kernels may read.
    static constexpr std::size_t padding = 16;
    template <class T>
    using OfBins = std::array<T, SunBins::count + padding>;

    OfBins<float> sine{}, cosine{};  ///< of the azimuth
    OfBins<double> exactSine{}, exactCosine{};
    OfBins<float> highestTan{};  ///< tangent of the highest sun's altitude; 0 without a sun

    explicit BinDirections(const SunBins& suns);
};

/// Tangents up to which suns are hidden at the middle of each bin; `always`: all are. Entries beyond the last
/// bin must be `always`.
using BinTangents = BinDirections::OfBins<float>;

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
