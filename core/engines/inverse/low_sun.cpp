#include "core/engines/inverse/low_sun.h"

#include <cmath>

#include "core/base/units.h"

namespace noonmark {

SunInterval cutInterval(const SunInterval& interval, StepRange part) {
    return {part.first == 0 ? interval.first : interval.at(part.first),
            part.end == interval.steps ? interval.last : interval.at(part.end - 1), part.end - part.first};
}

LowSun::LowSun(double limitDeg) : limitZ_(float(std::sin(Degrees{limitDeg}.radians().value))) {}

StepRange LowSun::stepsAbove(const SunInterval& interval) const {
    StepRange range{0, interval.steps};
    while (!range.empty() && is(glm::vec3(interval.at(range.first)))) ++range.first;
    while (!range.empty() && is(glm::vec3(interval.at(range.end - 1)))) --range.end;
    return range;
}

SunSteps LowSun::of(const SunSteps& directions, bool low) const {
    SunSteps some;
    for (const SunStep& step : directions.steps)
        if (is(step.direction) == low) some.steps.push_back(step);
    return some;
}

}  // namespace noonmark
