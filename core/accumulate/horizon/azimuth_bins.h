#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// The steps of a period whose suns stand within one bin of azimuth, taken as if all stood in one direction.
class AzimuthBin {
public:
    /// `away`: unit vector that shadows run along. `tans`: tangents of the steps' altitudes, at least one,
    /// ascending.
    AzimuthBin(glm::dvec2 away, std::vector<float> tans);

    [[nodiscard]] glm::dvec2 away() const { return away_; }
    [[nodiscard]] float lowestTan() const { return tans_.front(); }
    [[nodiscard]] std::span<const float> tans() const { return tans_; }

    /// How many steps a horizon of this slope hides: those with tan(altitude) < slope. A few nanoseconds.
    [[nodiscard]] std::int16_t hidden(float slope) const {
        if (!(slope > tans_.front())) return 0;
        if (slope > tans_.back()) return std::int16_t(tans_.size());
        std::size_t rank = firstAt_[keyOf(slope) - lowestKey_];
        while (tans_[rank] < slope) ++rank;
        return std::int16_t(rank);
    }

private:
    // A slope's exponent and leading bits: 128 keys for each doubling.
    static std::uint32_t keyOf(float slope);

    glm::dvec2 away_;
    std::vector<float> tans_;
    std::uint32_t lowestKey_;
    std::vector<std::int16_t> firstAt_;  // by key: the first step not below all slopes of that key
};

/// Where a step of the period is found among the bins: hidden where its rank < hidden(slope of that bin).
struct StepPlace {
    std::uint16_t bin = 0;
    std::int16_t rank = 0;  ///< in the order of altitude, 0 the lowest
};

/// A period as the horizon sweep sees it.
struct BinnedSun {
    static constexpr std::size_t mostStepsABin = 32'000;  ///< ranks fit 16 bits; fuller bins are cut in two
    std::vector<AzimuthBin> bins;                         ///< only those that the sun visits
    std::vector<StepPlace> places;                        ///< one a step, in time order
};

/// Bins of `widthDeg` from north clockwise. A bin's direction is the mean of its steps'. O(steps log steps).
BinnedSun binnedSun(const SunSteps& sun, double widthDeg);

}  // namespace noonmark
