#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/review/rule/rule.h"
#include "core/sun/day_clock.h"

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

/// A moment at which a rule wants shadows drawn.
struct RuleMoment {
    CivilDate day;
    double minutes = 0;  ///< since midnight, on the rule's clock
    std::string clock;   ///< "09:00"
    SunStep sun;
};

struct RuleMomentSettings {
    /// For a rule about a range of days: days to draw besides the 21st of March, June, September and
    /// December: that of most shadow.
    std::vector<std::chrono::month_day> moreDays;
    int maxHoursADay = 0;  ///< where the rule names no times; 0: every full hour of its hours
};

/// The rule's fixed days, or of a range those above, at the times of its diagrams, or else at full hours of
/// its hours, noon among them; in time order. Moments with the sun below the horizon, or below the rule's
/// lowest altitude, are left out. Errors as of computeRuleSun().
Result<std::vector<RuleMoment>> computeRuleMoments(const Rule& rule, const RuleSite& site,
                                                   const RuleMomentSettings& settings = {},
                                                   const std::stop_token& stop = {});

/// The plane that the rule's shadows are drawn on, metres above the mean ground; nothing where it is about
/// the ground or windows.
std::optional<double> planeOf(const Rule& rule);

/// Whether the rule's diagrams have lines of equal hours of shadow.
bool hasIsochrones(const Rule& rule);
/// For a rule about more days, lines are drawn on so many of them.
inline constexpr std::size_t maxIsochroneDays = 4;
/// The minutes of these lines, ascending: each full hour up to 8, and the rule's limits of the total at a
/// spot.
std::vector<double> listIsochroneMinutes(const Rule& rule);
/// Only the limits of the total at a spot, minutes; ascending.
std::vector<double> listLimitMinutes(const Rule& rule);

}  // namespace noonmark
