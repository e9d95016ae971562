#pragma once

#include "app/gui/view/time/sun_at_moment.h"

namespace noonmark {

/// What play repeats.
enum class SunLoop { day, year };

/// The look a little later, when the sun is played: over the day's light, or over the dates of the year at
/// the same time of day. Wraps around. `speed`: hours of the day or weeks of the year in a second.
TimeLook advance(const TimeLook& look, const SunAtMoment& sun, SunLoop loop, double seconds, double speed);

/// The look moved by minutes and days, within its year and its day.
TimeLook nudge(TimeLook look, int minutes, int days);

}  // namespace noonmark
