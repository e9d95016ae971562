#include "core/accumulate/horizon/horizon_case.h"

#include <fmt/format.h>

#include "core/accumulate/horizon_sweep.h"

namespace noonmark {

namespace {
constexpr std::uint32_t mostStepsADay = 32'767;  // runs are counted in 16 bits
}

Result<void> checkBinWidth(double binDeg) {
    if (binDeg >= HorizonSweepSettings::minBinDeg && binDeg <= HorizonSweepSettings::maxBinDeg) return {};
    return failure(fmt::format("An azimuth bin of {} deg is out of range", binDeg), "bin width",
                   "Choose 0.1 to 2 deg");
}

Result<void> checkHorizonDays(const SunSteps& sun) {
    for (const SunDay& day : sun.days)
        if (day.count > mostStepsADay)
            return failure(fmt::format("A day of {} steps is more than the horizon sweep counts", day.count),
                           "step", "Choose a step of 3 seconds or more");
    return {};
}

}  // namespace noonmark
