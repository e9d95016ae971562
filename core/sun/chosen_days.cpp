#include "core/sun/chosen_days.h"

namespace noonmark {

SunSteps chooseDays(const SunSteps& sun, std::span<const std::size_t> days) {
    SunSteps chosen;
    chosen.stepMinutes = sun.stepMinutes;
    for (const std::size_t number : days) {
        SunDay day = sun.days[number];
        const auto from = sun.steps.begin() + day.first;
        day.first = std::uint32_t(chosen.steps.size());
        chosen.steps.insert(chosen.steps.end(), from, from + day.count);
        chosen.belowHorizon += day.belowHorizon;
        chosen.days.push_back(day);
    }
    return chosen;
}

}  // namespace noonmark
