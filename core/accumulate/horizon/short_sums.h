#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/sun_change.h"

namespace noonmark {

/// Sums of some numbers in 16 bits, for as long as they cannot overflow. Through all bins they stay in the
/// first-level cache. `lines`: of numbers from `first` on, up to `mostNumbers` of them; flush() before they
/// are read.
class ShortSums {
public:
    static constexpr std::size_t mostNumbers = 16'384;

    ShortSums(std::size_t first, std::span<const Stretch> lines, std::uint32_t* all)
        : first_(first), lines_(lines), all_(all) {}

    void add(const SunChange& change, const HorizonCode* horizons) {
        constexpr int mostShort = std::numeric_limits<std::int16_t>::max();
        if (most_ + change.most() > mostShort) flush();
        most_ += change.most();
        for (const auto& [first, end] : lines_)
            change.addTo(horizons + first, end - first, sums_.data() + (first - first_));
    }

    void flush() {
        for (const auto& [first, end] : lines_)
            for (std::size_t i = first; i < end; ++i)
                all_[i] += std::uint32_t(int(std::exchange(sums_[i - first_], std::int16_t(0))));
        most_ = 0;
    }

private:
    std::size_t first_;
    std::span<const Stretch> lines_;
    std::uint32_t* all_;
    int most_ = 0;
    std::array<std::int16_t, mostNumbers> sums_{};
};

}  // namespace noonmark
