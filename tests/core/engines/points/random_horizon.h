#pragma once

#include <chrono>
#include <limits>
#include <random>

#include "core/engines/points/horizons/bin_horizon.h"

namespace noonmark::tests {

/// A horizon of random steps, some hidden altogether, with gaps in some bins.
inline BinHorizon randomHorizon(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto upTo = [&](double maximum) { return maximum * double(random() % 1000) / 1000; };
    BinHorizon horizon;
    float tan = 0;
    for (std::size_t bin = 0; bin < SunBins::count; ++bin) {
        horizon.firstGap[bin] = std::uint32_t(horizon.gaps.size());
        if (random() % 30 == 0)
            tan = random() % 3 == 0 ? std::numeric_limits<float>::infinity() : float(upTo(2));
        horizon.tan[bin] = tan;
        double low = double(tan);
        for (int gaps = random() % 20 == 0 ? 1 + int(random() % 2) : 0; gaps > 0; --gaps) {
            low += 0.001 + upTo(1);
            horizon.gaps.push_back({low, low + upTo(0.5)});
            low = horizon.gaps.back().highTan;
        }
    }
    horizon.firstGap[SunBins::count] = std::uint32_t(horizon.gaps.size());
    return horizon;
}

/// A date for each day, from 20 January on.
inline void numberDays(SunSteps& sun) {
    for (std::size_t day = 0; day < sun.days.size(); ++day)
        sun.days[day].date = std::chrono::sys_days(std::chrono::year(2026) / 1 / 20) + std::chrono::days(day);
}

}  // namespace noonmark::tests
