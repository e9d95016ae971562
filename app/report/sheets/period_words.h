#pragma once

#include <QString>

#include "core/sun/period.h"

namespace noonmark {

QString describeDates(CivilDate date);  ///< "21 March 2026"

/// The days: "21 March 2026"; "21 March 2026 to 19 April 2026 (30 days)".
QString describeDays(const Period& period);

/// The hours of a day: "09:00 to 15:00, every 1 min"; "at 12:00"; "sunrise + 90 min to sunset - 90 min, every
/// 1 min".
QString describeHours(const Period& period);

/// Days, hours and zone in one line.
QString describePeriod(const Period& period);

}  // namespace noonmark
