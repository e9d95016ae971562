#pragma once

#include "core/engines/horizon/horizon_sweep.h"
#include "tests/core/engines/scenes.h"

namespace noonmark::tests {

/// By bins fine enough that what is left of the error is not theirs.
inline ShadowField swept(const City& city, const Receivers& receivers, const SunSteps& sun,
                         double binDeg = 0.2) {
    NoProgress progress;
    return HorizonSweep({.binDeg = binDeg}).accumulate(city, receivers, sun, progress, {}).value();
}

/// Winter, spring and summer in the middle latitudes.
inline SunSteps threeDays() {
    SunSteps sun;
    for (const double noon : {22.0, 41.0, 68.0}) addDay(sun, arc(260, noon));
    return sun;
}

}  // namespace noonmark::tests
