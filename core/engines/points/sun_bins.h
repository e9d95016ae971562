#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// The sun of a step as the sweep sees it.
struct BinnedSun {
    std::uint16_t bin;  ///< of its azimuth, below SunBins::count
    float tan;          ///< tangent of its altitude
};
BinnedSun binSun(const SunStep& step);

/// The suns of a period by azimuth, so that the minutes above or below an altitude are looked up and not
/// counted.
class SunBins {
public:
    static constexpr int count =
        1440;  ///< bins of a quarter of a degree in the local frame, from +y, clockwise
    using Months = std::array<std::int32_t, 12>;

    /// O(n log n), some 100 bytes a step.
    explicit SunBins(const SunSteps& sun);

    [[nodiscard]] bool empty(int bin) const {
        return first_[std::size_t(bin)] == first_[std::size_t(bin) + 1];
    }
    /// Tangent of the highest sun's altitude; the bin must not be empty.
    [[nodiscard]] float highestTan(int bin) const { return tans_[first_[std::size_t(bin) + 1] - 1]; }
    /// Adds `sign` x the number of suns of the bin up to a tangent, by month; `inclusive`: and at it.
    void addUpTo(int bin, float tan, bool inclusive, int sign, Months& months) const;
    void addAll(int bin, Months& months) const;

private:
    std::vector<std::uint32_t> first_;  // of each bin in tans_, and the end
    std::vector<float> tans_;           // ascending in each bin
    // For each bin one entry more than suns: how many of its suns, by month, come before the k-th.
    std::vector<std::array<std::uint16_t, 12>> before_;
};

}  // namespace noonmark
