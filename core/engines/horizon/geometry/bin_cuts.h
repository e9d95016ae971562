#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/api/shadow_counts.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The limits of a period's azimuth bins.
struct BinCuts {
    static constexpr int slots = 36'000;  ///< 0.01 deg each, from north clockwise; the resolution of cuts
    static constexpr std::uint16_t none = 0xFFFF;  ///< marks a slot that the sun does not visit
    std::vector<std::uint16_t> binOfSlot;          ///< one per slot, ascending
    std::size_t bins = 0;
    double narrowestDeg = 0, widestDeg = 0;  ///< of a bin, from its first sun to the next bin's
};

/// Azimuth of the sun's direction from grid north clockwise, 0 <= azimuth < 360. Computed from the direction
/// alone, so that it agrees with the rays of the reference.
double computeAzimuthDeg(const SunStep& step);
int findAzimuthSlot(double azimuthDeg);

/// Chooses the fewest bins whose expected error is within `targetPercent`: the mean error of a cell's gross
/// shadow in a dense city, percent of the period, if the suns of each bin are placed at the bin's mean
/// azimuth. A sun is counted wrongly if a vertical edge of the skyline lies between it and that mean. An edge
/// at a given azimuth puts all suns beyond it on the wrong side, so the squared error grows with the square
/// of their number, summed over the possible positions of an edge. Suns 10 deg of altitude apart meet
/// different edges, so their errors are independent. One constant is measured: the number and height of edges
/// in a city (bin_cuts.cpp).
///
/// Every bin has the same sum of its suns' angular distances from their mean, so bins are narrow where the
/// sun spends most time. No bin is wider than 2 deg. If longest runs are counted, no bin is wider than 0.5
/// deg per 0.05 % of the target either, 0.25 deg at steps of up to a minute. If the target requires it, each
/// sun gets a bin of its own, at a resolution of 0.01 deg. O(steps) + 5 ms.
BinCuts chooseBinCuts(const SunSteps& sun, double targetPercent,
                      ShadowCounts counts = ShadowCounts::grossAndRuns);

}  // namespace noonmark
