#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"

namespace noonmark {

/// Accumulates sums in 16 bits for as long as they cannot overflow, so that they stay in the first-level
/// cache through all bins. `lines`: ranges of numbers from `first` on, up to `maxNumbers` in total; call
/// flush() before reading `all`. `lines` and `all` must outlive it.
template <std::size_t maxNumbers>
class ShortSums {
public:
    ShortSums(std::size_t first, std::span<const NumberRange> lines, std::uint32_t* all)
        : first_(first), lines_(lines), all_(all) {}

    void add(const CountChange& change, const HorizonCode* horizons) {
        constexpr int maxShort = std::numeric_limits<std::int16_t>::max();
        if (most_ + change.most() > maxShort) flush();
        most_ += change.most();
        for (const auto& [first, end] : lines_)
            change.addTo(horizons + first, end - first, sums_.data() + (first - first_));
    }

    void flush() {
        for (const auto& [first, end] : lines_)
            for (std::size_t i = first; i < end; ++i) all_[i] += std::uint32_t(int(sums_[i - first_]));
        sums_.fill(0);
        most_ = 0;
    }

private:
    std::size_t first_;
    std::span<const NumberRange> lines_;
    std::uint32_t* all_;
    int most_ = 0;
    std::array<std::int16_t, maxNumbers> sums_{};
};

/// For the numbers of a tile: half of a first-level cache.
inline constexpr std::size_t maxShortNumbers = 16'384;
using TileShortSums = ShortSums<maxShortNumbers>;

}  // namespace noonmark
