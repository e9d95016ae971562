#pragma once

#include <array>
#include <cstdint>
#include <vector>

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

}  // namespace noonmark
