#include "app/gui/view/time/sun_walk.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

using std::chrono::days;
using std::chrono::minutes;
using std::chrono::sys_days;

constexpr int lastMinute = 24 * 60 - 1;

sys_days firstOf(std::chrono::year year) { return year / std::chrono::January / 1; }

int daysIn(std::chrono::year year) {
    return int((firstOf(year + std::chrono::years(1)) - firstOf(year)).count());
}

CivilDate dayOf(std::chrono::year year, int index) { return CivilDate(firstOf(year) + days(index)); }

int indexOf(CivilDate date) { return int((sys_days(date) - firstOf(date.year())).count()); }

// From sunrise to sunset; the whole day where there is no night or no day.
TimeLook laterToday(TimeLook look, const SunAtMoment& sun, int step) {
    const int first = sun.sunriseMin.value_or(0), last = sun.sunsetMin.value_or(lastMinute);
    const int next = int(look.at.count()) + step;
    const bool over = last > first && (next > last || next < first);
    look.at = minutes(over ? first : next % (lastMinute + 1));
    return look;
}

}  // namespace

TimeLook advance(const TimeLook& look, const SunAtMoment& sun, SunLoop loop, double seconds, double speed) {
    if (loop == SunLoop::day)
        return laterToday(look, sun, std::max(1, int(std::lround(60 * speed * seconds))));
    TimeLook later = look;
    const int step = std::max(1, int(std::lround(7 * speed * seconds)));
    later.date = dayOf(look.date.year(), (indexOf(look.date) + step) % daysIn(look.date.year()));
    return later;
}

TimeLook nudge(TimeLook look, int minutesLater, int daysLater) {
    look.at = minutes(std::clamp(int(look.at.count()) + minutesLater, 0, lastMinute));
    const auto year = look.date.year();
    look.date = dayOf(year, std::clamp(indexOf(look.date) + daysLater, 0, daysIn(year) - 1));
    return look;
}

}  // namespace noonmark
