#include "core/engines/accrual/accrual_settings.h"

#include <fmt/format.h>

#include "core/engines/common/shadow_mask.h"

namespace noonmark {

namespace {

tl::unexpected<Error> outOfRange(std::string what, const char* where, double low, double high,
                                 const char* unit) {
    return failure(std::move(what) + " is out of range", where,
                   fmt::format("Choose {} to {}{}", low, high, unit));
}

}  // namespace

Result<void> check(const AccrualSettings& settings) {
    using S = AccrualSettings;
    if (settings.mapSize < S::minMapSize || settings.mapSize > S::maxMapSize)
        return outOfRange(fmt::format("A shadow map of {} texels a side", settings.mapSize), "map size",
                          S::minMapSize, S::maxMapSize, " texels");
    if (!(settings.biasM >= 0 && settings.biasM <= S::maxBiasM))
        return outOfRange(fmt::format("A bias of {} m", settings.biasM), "bias", 0, double(S::maxBiasM),
                          " m");
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
