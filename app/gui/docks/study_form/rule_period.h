#pragma once

#include <optional>

#include "core/review/rule/rule.h"
#include "core/sun/period.h"

namespace noonmark {

/// The hours and step of a rule on one of its fixed days, in the year and zone of `period`. Nothing where a
/// study's period cannot state them: hours between bounds of several kinds, a clock other than the wall
/// clock, steps that begin on full hours, or sun above a lowest altitude only.
std::optional<Period> periodOf(const Rule& rule, std::chrono::month_day day, const Period& period);

/// The same for a rule about a range of days, every one of which counts once.
std::optional<Period> periodOf(const Rule& rule, const Period& period);

}  // namespace noonmark
