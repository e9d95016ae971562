#pragma once

// Geometry of the horizon sweep. azimuth_bins.h and bin_cuts.h group the suns of a period into azimuth bins;
// azimuth_batch.h groups neighbouring bins. shadow_axes.h defines the coordinates of one azimuth and
// horizon_code.h the 16-bit horizon. receiver_blocks.h, block_place.h and block_grounds.h arrange receivers
// in blocks of 16 x 16. wall_list.h, solid_edges.h and terrain_edges.h collect prisms, general meshes and
// terrain; bin_walls.h cuts their outlines, as seen at one azimuth or batch, into pieces of wall, which
// piece_bounds.h filters for a block.

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/engines/horizon/geometry/bin_cuts.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

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
