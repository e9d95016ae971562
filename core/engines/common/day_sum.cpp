#include "core/engines/common/day_sum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/engines/api/blank_field.h"

namespace noonmark {

DaySum::DaySum(const Receivers& receivers, const SunSteps& sun)
    : receivers_(receivers), sun_(sun), steps_(receivers.cells.size()), longestMin_(receivers.cells.size()) {}

void DaySum::add(const ShadowField& part, const SunSteps& days) {
    const double stepsAMinute = part.days / part.stepMinutes;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const std::uint32_t cell = receivers_.cells[i];
        steps_[i] += std::uint32_t(std::lround(double(part.grossMin[cell]) * stepsAMinute));
        longestMin_[i] = std::max(longestMin_[i], part.continuousMin[cell]);
    }
    days_ += days.dayCount();
    sunlit_ += days.steps.size();
}

void DaySum::writeTo(ShadowField& field) const {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const std::uint32_t cell = receivers_.cells[i];
        field.grossMin[cell] = float(double(steps_[i]) * field.stepMinutes / field.days);
        field.continuousMin[cell] = longestMin_[i];
    }
}

PartialField DaySum::partial() const {
    PartialField partial{makeBlankField(receivers_, sun_), double(days_) / double(sun_.dayCount()),
                         fmt::format("{} of {} days", days_, sun_.dayCount())};
    writeTo(partial.field);
    partial.field.sunlitMinutesPerDay = double(sunlit_) * sun_.stepMinutes / partial.field.days;
    return partial;
}

}  // namespace noonmark
