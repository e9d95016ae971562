#include "core/engines/horizon/check_horizon_study.h"

#include <fmt/format.h>

#include "core/describe/field_checks.h"
#include "core/describe/text.h"

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
    return checkRanges(sweepFields().of(settings));
}

Result<void> checkHorizonDays(const SunSteps& sun) {
    for (const SunDay& day : sun.days)
        if (day.count > maxStepsADay)
            return failure(fmt::format("A day of {} steps is more than the horizon sweep counts", day.count),
                           "step", NM_TEXT("Choose a step of 3 seconds or more"));
    return {};
}

}  // namespace noonmark
