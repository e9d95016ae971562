#pragma once

#include "core/engines/horizon/horizon_sweep.h"
#include "tests/core/engines/scenes.h"

namespace noonmark::tests {

/// Sweeps with bins so narrow that any remaining error has another cause.
inline ShadowField swept(const City& city, const Receivers& receivers, const SunSteps& sun,
                         double binDeg = 0.2) {
    NoProgress progress;
    return HorizonSweep({.binDeg = binDeg}).accumulate(city, receivers, sun, progress, {}).value();
}

/// A winter, a spring and a summer day at a middle latitude.
inline SunSteps threeDays() {
    SunSteps sun;
    for (const double noon : {22.0, 41.0, 68.0}) addDay(sun, arc(260, noon));
    return sun;
}

}  // namespace noonmark::tests
