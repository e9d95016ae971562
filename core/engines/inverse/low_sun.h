#pragma once

#include "core/engines/common/interval_engine.h"

namespace noonmark {

/// Steps [first, end) of an interval.
struct StepRange {
    int first = 0;
    int end = 0;
    [[nodiscard]] bool empty() const { return first >= end; }
};

/// Those steps as an interval of their own; `part` must not be empty.
SunInterval cutInterval(const SunInterval& interval, StepRange part);

/// Distinguishes sun positions below a limit of altitude.
class LowSun {
public:
    explicit LowSun(double limitDeg);

    [[nodiscard]] bool is(glm::vec3 towardsSun) const { return towardsSun.z < limitZ_; }

    /// The steps with the sun at or above the limit. They are contiguous, because the sun's altitude has a
    /// single maximum on its path.
    [[nodiscard]] StepRange stepsAbove(const SunInterval& interval) const;

    /// The directions below the limit, or those that are not.
    [[nodiscard]] SunSteps of(const SunSteps& directions, bool low) const;

private:
    float limitZ_;
};

}  // namespace noonmark
