#include "core/lab/accrual/accrual_settings.h"

#include <fmt/format.h>

#include "core/describe/field_values.h"
#include "core/describe/text.h"
#include "core/engines/common/run_counter.h"

namespace noonmark {

namespace {

tl::unexpected<Error> outOfRange(std::string what, const char* where, double low, double high,
                                 const char* unit) {
    return failure(std::move(what) + " is out of range", where,
                   fmt::format("Give {} to {}{}", low, high, unit));
}

}  // namespace

const Fields<AccrualSettings>& accrualFields() {
    static const Fields<AccrualSettings> fields{
        field(&AccrualSettings::mapSize,
              {.key = "map",
               .label = NM_TEXT("Map size"),
               .help = NM_TEXT("Texels along a side of the depth map that is stretched over the region; no "
                               "more than cells are "
                               "used"),
               .unit = "texels",
               .range = ValueRange{AccrualSettings::minMapSize, AccrualSettings::maxMapSize}}),
        field(&AccrualSettings::biasM,
              {.key = "bias",
               .label = NM_TEXT("Bias"),
               .help = NM_TEXT("How high above the ground something must be to shade it"),
               .unit = "m",
               .range = ValueRange{0, 10}})};
    return fields;
}

Result<void> check(const AccrualSettings& settings) {
    using S = AccrualSettings;
    if (auto ranges = checkRanges(accrualFields().of(settings)); !ranges) return ranges;
    if (!(settings.slopeBias >= 0 && settings.slopeBias <= S::maxSlopeBias))
        return outOfRange(fmt::format("A slope bias of {} texels", settings.slopeBias), "slope bias", 0,
                          double(S::maxSlopeBias), " texels");
    return {};
}

Result<void> checkSteps(int steps) {
    if (steps >= 1 && steps <= maxMaskSteps) return {};
    return outOfRange(fmt::format("An interval of {} steps", steps), "interval", 1, maxMaskSteps, " steps");
}

}  // namespace noonmark
