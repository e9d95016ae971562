#include "core/sun/civil_time.h"

#include <fmt/format.h>

#include <cstdlib>

namespace noonmark {

using namespace std::chrono;

Instant Zone::instantAt(CivilDate date, minutes sinceMidnight) const {
    return instantOf(local_days{date} + sinceMidnight);
}

CivilDate Zone::dateAt(Instant at) const {
    const sys_seconds second = floor<seconds>(at);
    return floor<days>(second + offsetAt(second));
}

std::string Zone::text(Instant at) const {
    const minutes offset = floor<minutes>(offsetAt(floor<seconds>(at)));
    const auto wallClock = at + offset;
    const auto midnight = floor<days>(wallClock);
    const hh_mm_ss time{wallClock - midnight};
    std::string text = fmt::format("{}T{:02}:{:02}:{:02}", formatText(CivilDate{midnight}),
                                   time.hours().count(), time.minutes().count(), time.seconds().count());
    if (time.subseconds() != 0ms) text += fmt::format(".{:03}", time.subseconds().count());
    const auto size = abs(offset).count();
    return text + fmt::format("{}{:02}:{:02}", offset < 0min ? '-' : '+', size / 60, size % 60);
}

std::string formatText(CivilDate date) {
    return fmt::format("{:04}-{:02}-{:02}", int(date.year()), unsigned(date.month()), unsigned(date.day()));
}

std::string formatText(minutes timeOfDay) {
    return fmt::format("{:02}:{:02}", timeOfDay.count() / 60, timeOfDay.count() % 60);
}

}  // namespace noonmark
