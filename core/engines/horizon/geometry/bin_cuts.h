#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/api/shadow_counts.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Where the azimuth bins of a period begin and end.
struct BinCuts {
    static constexpr int slots = 36'000;  ///< 0.01 deg each, from north clockwise: as fine as cuts are
    static constexpr std::uint16_t none = 0xFFFF;  ///< of a slot that the sun does not visit
    std::vector<std::uint16_t> binOfSlot;          ///< one a slot, ascending
    std::size_t bins = 0;
    double narrowestDeg = 0, widestDeg = 0;  ///< of a bin, from its first sun to that of the next one
};

/// Of the sun's direction, from the grid's north clockwise, 0 <= azimuth < 360: in line with the rays of the
/// reference, which know only the direction.
double computeAzimuthDeg(const SunStep& step);
int findAzimuthSlot(double azimuthDeg);

/// The fewest bins whose expected error is within `targetPercent`: the mean error of a cell's gross shadow in
/// a dense city, percent of the period, where the suns of each bin are taken at the bin's mean azimuth. A sun
/// is counted wrongly where a vertical edge of the skyline stands between it and that mean. An edge at one
/// place puts all suns beyond it on the wrong side, so the square of the error grows with the square of their
/// number, summed over the places that an edge may have. Suns 10 deg of altitude apart meet different edges:
/// their errors are independent. One constant is measured: the number and height of edges in a city
/// (bin_cuts.cpp).
///
/// Each bin has the same sum of degrees that its
/// suns are off its mean, so bins are narrow where the sun spends its time. None is wider than 2 deg; for the
/// sake of the longest runs, where these are counted, nor than 0.5 deg for each 0.05 % of the target. Where a
/// target asks for it each sun has a bin of its own, to 0.01 deg. O(steps) + 5 ms.
BinCuts chooseBinCuts(const SunSteps& sun, double targetPercent,
                      ShadowCounts counts = ShadowCounts::grossAndRuns);

}  // namespace noonmark
