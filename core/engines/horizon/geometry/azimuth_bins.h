#pragma once

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

/// The steps of a period whose suns stand within one bin of azimuth, taken as if all stood in one direction.
struct AzimuthBin {
    std::uint32_t number;           ///< from north clockwise, in widths; an empty one has none
    glm::dvec2 away;                ///< unit vector that shadows run along
    std::vector<HorizonCode> suns;  ///< codes of its steps, at least one, ascending

    [[nodiscard]] HorizonCode lowest() const { return suns.front(); }
};

/// Numbers [first, end).
struct NumberRange {
    std::uint32_t first, end;
};

/// How many of some suns a horizon hides, looked up.
class HiddenSuns {
public:
    /// `suns`: ascending; none is fine. 4 bytes for each level between the lowest and the highest.
    explicit HiddenSuns(std::span<const HorizonCode> suns) : HiddenSuns(suns, {}) {}
    /// How many more of `suns` than of `others`, modulo 2^32.
    HiddenSuns(std::span<const HorizonCode> suns, std::span<const HorizonCode> others);

    [[nodiscard]] std::uint32_t operator()(HorizonCode horizon) const {
        return counts_[std::size_t(std::clamp(int(horizon) - lowest_, 0, last_))];
    }

    /// Adds the count of each horizon to its sum. A table of small counts is read in 16 bits: it stays in
    /// cache.
    void addTo(const HorizonCode* horizons, std::span<const NumberRange> of, std::uint32_t* sums) const;

private:
    int lowest_ = 0, last_ = 0;
    std::vector<std::uint32_t> counts_;
    std::vector<std::int16_t> short_;  // the same, where they fit
};

/// Where a step of the period is found among the bins: hidden by a horizon of that bin above its code.
struct StepPlace {
    std::uint16_t bin = 0;
    HorizonCode sun = 0;
};

/// A period as the horizon sweep sees it.
struct BinnedSun {
    std::vector<AzimuthBin> bins;            ///< only those that the sun visits
    std::vector<StepPlace> places;           ///< one a step, in time order
    double narrowestDeg = 0, widestDeg = 0;  ///< width of a bin
};

/// "361 azimuth bins of 0.5 deg", "330 azimuth bins of 0.31 to 1.2 deg"
std::string textOf(const BinnedSun& binned);

/// Where the suns of a bin are taken to stand.
enum class BinDirection {
    meanOfSteps,  ///< the most exact
    middle,       ///< the same for every period: horizons can be kept
};

/// The way that shadows run where the sun stands in the middle of a bin.
glm::dvec2 computeMiddleDirection(std::uint32_t bin, double widthDeg);

/// Bins of `widthDeg` from north clockwise. O(steps log steps).
BinnedSun binSun(const SunSteps& sun, double widthDeg, BinDirection direction = BinDirection::meanOfSteps);

/// Bins as cut for this period, each taken at the mean of its steps.
BinnedSun binSun(const SunSteps& sun, const BinCuts& cuts);

/// Bins as the settings ask: of their width, or else as their error target needs. A valid setting.
BinnedSun binSun(const SunSteps& sun, const HorizonSweepSettings& settings);

/// How many bins those of binSun(sun, settings) are.
std::size_t binCount(const SunSteps& sun, const HorizonSweepSettings& settings);

}  // namespace noonmark
