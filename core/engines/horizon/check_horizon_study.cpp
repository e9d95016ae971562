#include "core/engines/horizon/check_horizon_study.h"

#include <fmt/format.h>

namespace noonmark {

namespace {
constexpr std::uint32_t maxStepsADay = 32'767;  // runs are counted in 16 bits
}

Result<void> checkBinWidth(double binDeg) {
    if (binDeg >= HorizonSweepSettings::minBinDeg && binDeg <= HorizonSweepSettings::maxBinDeg) return {};
    return failure(fmt::format("An azimuth bin of {} deg is out of range", binDeg), "bin width",
                   fmt::format("Choose {:g} to {:g} deg", HorizonSweepSettings::minBinDeg,
                               HorizonSweepSettings::maxBinDeg));
}

Result<void> checkSweepSettings(const HorizonSweepSettings& settings) {
    if (settings.binDeg != 0) return checkBinWidth(settings.binDeg);
    const double percent = settings.errorTargetPercent;
    if (percent >= HorizonSweepSettings::minErrorPercent && percent <= HorizonSweepSettings::maxErrorPercent)
        return {};
    return failure(fmt::format("An error target of {} % is out of range", percent), "error target",
                   fmt::format("Choose {:g} to {:g} %", HorizonSweepSettings::minErrorPercent,
                               HorizonSweepSettings::maxErrorPercent));
}

Result<void> checkHorizonDays(const SunSteps& sun) {
    for (const SunDay& day : sun.days)
        if (day.count > maxStepsADay)
            return failure(fmt::format("A day of {} steps is more than the horizon sweep counts", day.count),
                           "step", "Choose a step of 3 seconds or more");
    return {};
}

}  // namespace noonmark
