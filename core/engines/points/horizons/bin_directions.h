#pragma once

#include <array>
#include <limits>

#include "core/engines/points/horizons/sun_bins.h"

namespace noonmark {

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

}  // namespace noonmark
