#pragma once

#include "core/engines/common/interval_engine.h"

namespace noonmark {

/// Steps of an interval, [first, end).
struct StepRange {
    int first = 0;
    int end = 0;
    [[nodiscard]] bool empty() const { return first >= end; }
};

/// Those steps as an interval of their own; `part` is not empty.
SunInterval cutInterval(const SunInterval& interval, StepRange part);

/// Which suns stand lower than a limit.
class LowSun {
public:
    explicit LowSun(double limitDeg);

    [[nodiscard]] bool is(glm::vec3 towardsSun) const { return towardsSun.z < limitZ_; }

    /// The steps with the sun at the limit or above: neighbours, for on its way the sun's height has one top.
    [[nodiscard]] StepRange stepsAbove(const SunInterval& interval) const;

    /// The directions that are lower, or those that are not.
    [[nodiscard]] SunSteps of(const SunSteps& directions, bool low) const;

private:
    float limitZ_;
};

}  // namespace noonmark
