#pragma once

#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/review/rule/rule.h"
#include "core/sun/day_clock.h"
#include "core/sun/day_hours.h"

namespace noonmark {

/// Where and when a rule is evaluated.
struct RuleSite {
    Observer observer;
    std::string zone;  ///< IANA name; the rule's clock refers to it
    int year = 2026;   ///< of rules that name none; 1901 to 2099
};

/// The days of a rule in one year, as steps of the sun.
struct RuleSun {
    SunSteps sun;                 ///< days in time order
    std::vector<double> weights;  ///< by day: days of the year that it stands for; 1 for fixed days
    DayClock clock;
    int year = 0;
    Warnings warnings{};  ///< that the rule's seasons are those of the other half of the earth
};

/// The dates of a rule in a year, in time order, with the number of days that each stands for. The weights of
/// a range add up to its days. Error: 29 February in a year that has none.
Result<std::vector<std::pair<CivilDate, double>>> datesOf(const RuleDays& days, int year);

/// The sun of a rule's days, hours and clock at a site. With `roundTo`, steps begin on full minutes of the
/// clock that it divides. A day whose hours are empty (polar night, sunset before the hours begin) has no
/// steps. Error: as computeSunSteps(), an unknown zone, and datesOf().
Result<RuleSun> computeRuleSun(const Rule& rule, const RuleSite& site, const std::stop_token& stop = {});

}  // namespace noonmark
