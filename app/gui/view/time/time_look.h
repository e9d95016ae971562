#pragma once

#include <QString>

#include "core/sun/period.h"

namespace noonmark {

/// Which part of a study's period is displayed.
enum class LookSpan {
    period,  ///< all of it
    day,     ///< its hours on one day
    moment,  ///< one moment of one day
};

/// A part of time displayed instead of the whole period of a study.
struct TimeLook {
    LookSpan span = LookSpan::period;
    CivilDate date{std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    std::chrono::minutes at{12 * 60};  ///< wall clock, 0 to 24 h; used for a moment only
    bool operator==(const TimeLook&) const = default;
};

/// The period of a look. Time zone, air, step and hours are those of the study.
Period periodOf(const TimeLook& look, const Period& study);

/// The initial look for a period: its first day, at noon or the middle of its hours.
TimeLook firstLook(const Period& study);

/// "21 March 2026", "21 March 2026, 14:35"; empty for the whole period.
QString describe(const TimeLook& look);

}  // namespace noonmark
