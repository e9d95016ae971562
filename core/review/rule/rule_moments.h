#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/review/rule/rule_days.h"

namespace noonmark {

/// A moment at which a rule wants shadows drawn.
struct RuleMoment {
    CivilDate day;
    double minutes = 0;  ///< since midnight, on the rule's clock
    std::string clock;   ///< "09:00"
    SunStep sun;
};

struct RuleMomentSettings {
    /// Of a rule about a range of days, days to draw besides the 21st of March, June, September and December:
    /// that of most shadow.
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
/// Of a rule about more days, lines are drawn for so many.
inline constexpr std::size_t maxIsochroneDays = 4;
/// The minutes of these lines, ascending: each full hour up to 8, and the rule's limits of the total at a
/// spot.
std::vector<double> listIsochroneMinutes(const Rule& rule);
/// Only the limits of the total at a spot, minutes; ascending.
std::vector<double> listLimitMinutes(const Rule& rule);

}  // namespace noonmark
