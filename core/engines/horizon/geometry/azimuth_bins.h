#pragma once

// Geometry of the horizon sweep. This file groups the suns of a period into azimuth bins; azimuth_batch.h
// groups neighbouring bins. shadow_axes.h defines the coordinates of one azimuth and horizon_code.h the
// 16-bit horizon. receiver_blocks.h arranges receivers in blocks of 16 x 16, and shadow_axes.h gives their
// ground heights. wall_list.h collects prisms, general meshes and terrain; bin_walls.h cuts their outlines,
// as seen at one azimuth or batch, into pieces of wall, and filters these for a block.

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/horizon_sweep.h"
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
/// in a city (azimuth_bins.cpp).
///
/// Every bin has the same sum of its suns' angular distances from their mean, so bins are narrow where the
/// sun spends most time. No bin is wider than 2 deg. If longest runs are counted, no bin is wider than 0.5
/// deg per 0.05 % of the target either, 0.25 deg at steps of up to a minute. If the target requires it, each
/// sun gets a bin of its own, at a resolution of 0.01 deg. O(steps) + 5 ms.
BinCuts chooseBinCuts(const SunSteps& sun, double targetPercent,
                      ShadowCounts counts = ShadowCounts::grossAndRuns);

/// The steps of a period whose suns lie within one azimuth bin; the sweep treats them as if all had the same
/// azimuth.
struct AzimuthBin {
    std::uint32_t number;           ///< index from north clockwise, in bin widths; empty bins are left out
    glm::dvec2 away;                ///< unit vector in which shadows fall
    std::vector<HorizonCode> suns;  ///< codes of the steps' suns, at least one, ascending

    [[nodiscard]] HorizonCode lowest() const { return suns.front(); }
    /// Number of suns that a horizon hides; for many horizons see HiddenSuns.
    [[nodiscard]] std::uint32_t hiddenBy(HorizonCode horizon) const {
        return std::uint32_t(std::ranges::lower_bound(suns, horizon) - suns.begin());
    }
};

/// A range of numbers [first, end).
struct NumberRange {
    std::uint32_t first, end;
};

/// A lookup table for how many of a set of suns a horizon hides; for many horizons see CountChange.
class HiddenSuns {
public:
    /// `suns`: ascending; may be empty. 4 bytes per level between the lowest and the highest.
    explicit HiddenSuns(std::span<const HorizonCode> suns) : HiddenSuns(suns, {}) {}
    /// Looks up how many more of `suns` than of `others` are hidden, modulo 2^32.
    HiddenSuns(std::span<const HorizonCode> suns, std::span<const HorizonCode> others);

    [[nodiscard]] std::uint32_t operator()(HorizonCode horizon) const {
        return counts_[std::size_t(std::clamp(int(horizon) - lowest_, 0, last_))];
    }

private:
    int lowest_ = 0, last_ = 0;
    std::vector<std::uint32_t> counts_;
};

/// The bin and code of a step of the period: it is hidden by a horizon of that bin above its code.
struct StepPlace {
    std::uint16_t bin = 0;
    HorizonCode sun = 0;
};

/// A period grouped into azimuth bins.
struct BinnedSun {
    std::vector<AzimuthBin> bins;            ///< only those that the sun visits
    std::vector<StepPlace> places;           ///< one per step, in time order
    double narrowestDeg = 0, widestDeg = 0;  ///< widths of the bins
};

/// "361 azimuth bins of 0.5 deg", "330 azimuth bins of 0.31 to 1.2 deg"
std::string formatText(const BinnedSun& binned);

/// The azimuth assigned to all suns of a bin.
enum class BinDirection {
    meanOfSteps,  ///< the most accurate
    middle,       ///< the same for every period, so horizons can be cached
};

/// The direction in which shadows fall if the sun is at the middle of a bin.
glm::dvec2 computeMiddleDirection(std::uint32_t bin, double widthDeg);

/// Groups the suns into bins of `widthDeg` from north clockwise. O(steps log steps).
BinnedSun binSun(const SunSteps& sun, double widthDeg, BinDirection direction = BinDirection::meanOfSteps);

/// Groups the suns into the bins cut for this period, each at the mean azimuth of its steps.
BinnedSun binSun(const SunSteps& sun, const BinCuts& cuts);

/// Groups the suns as the settings require: with the given bin width, or as the error target needs. Settings
/// must be valid.
BinnedSun binSun(const SunSteps& sun, const HorizonSweepSettings& settings);

/// Number of bins of binSun(sun, settings).
std::size_t binCount(const SunSteps& sun, const HorizonSweepSettings& settings);

}  // namespace noonmark
