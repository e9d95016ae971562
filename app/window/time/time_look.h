#pragma once

#include <QString>

#include "core/sun/period.h"

namespace noonmark {

/// How much of a study's time is looked at.
enum class TimeSpan {
    period,  ///< all of it
    day,     ///< its hours on one day
    moment,  ///< one moment of one day
};

/// A part of time that is looked at beside the whole period of a study.
struct TimeLook {
    TimeSpan span = TimeSpan::period;
    CivilDate date{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    std::chrono::minutes at{12 * 60};  ///< wall clock, 0 to 24 h; of a moment only
    bool operator==(const TimeLook&) const = default;
};

/// The period that is looked at: zone, air, step and hours are those of the study.
Period periodOf(const TimeLook& look, const Period& study);

/// Where a look at this period begins: its first day, at noon or the middle of its hours.
TimeLook firstLook(const Period& study);

/// "21 March 2026", "21 March 2026, 14:35"; empty for the whole period.
QString describe(const TimeLook& look);

}  // namespace noonmark
