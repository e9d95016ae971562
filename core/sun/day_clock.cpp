#include "core/sun/day_clock.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/wording.h"
#include "core/describe/fill_text.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

using namespace std::chrono;

constexpr double minutesPerDegree = 4;  // the sun turns 360 degrees in 1440 minutes of its own time
constexpr double noonMin = 720;

milliseconds millisecondsOf(double minutes) { return milliseconds{std::llround(minutes * 60000)}; }

double minutesIn(milliseconds span) { return double(span.count()) / 60000; }

std::string offsetText(double hours) {
    const int minutes = int(std::lround(std::abs(hours) * 60));
    return fmt::format("UTC{}{:02}:{:02}", hours < 0 ? '-' : '+', minutes / 60, minutes % 60);
}

}  // namespace

DayClock::DayClock(ClockSettings settings, Zone zone, std::shared_ptr<const Ephemeris> ephemeris,
                   double lonDeg)
    : settings_(settings), zone_(std::move(zone)), sun_(std::move(ephemeris)), lonDeg_(lonDeg) {}

seconds DayClock::standardOffset(CivilDate date) const {
    if (settings_.kind == ClockKind::fixed) return seconds{std::llround(settings_.offsetHours * 3600)};
    const auto offsetOn = [&](month_day day) {
        return zone_.offsetAt(sys_days{date.year() / day.month() / day.day()});
    };
    return std::min(offsetOn(January / 1), offsetOn(July / 1));
}

Instant DayClock::solarInstant(CivilDate date, double minutes) const {
    Instant at = sys_days{date} + millisecondsOf(minutes - lonDeg_ * minutesPerDegree);
    for (int i = 0; i < 5; ++i) {
        const double off = (minutes - noonMin) / minutesPerDegree - sun_->hourAngle(at).degrees().value;
        at += millisecondsOf(std::remainder(off, 360.0) * minutesPerDegree);
    }
    return at;
}

Instant DayClock::instantAt(CivilDate date, double minutes) const {
    if (settings_.kind == ClockKind::trueSolar) return solarInstant(date, minutes);
    if (settings_.kind != ClockKind::civil)
        return sys_days{date} + millisecondsOf(minutes) - standardOffset(date);
    const auto whole = std::chrono::minutes{std::int64_t(std::floor(minutes))};
    return zone_.instantAt(date, whole) + millisecondsOf(minutes - std::floor(minutes));
}

double DayClock::minutesOf(CivilDate date, Instant at) const {
    if (settings_.kind == ClockKind::trueSolar) {
        const double estimate = minutesIn(at - sys_days{date}) + lonDeg_ * minutesPerDegree;
        const double solar = noonMin + sun_->hourAngle(at).degrees().value * minutesPerDegree;
        return estimate + std::remainder(solar - estimate, 1440.0);
    }
    const seconds offset =
        settings_.kind == ClockKind::civil ? zone_.offsetAt(floor<seconds>(at)) : standardOffset(date);
    return minutesIn(at + offset - sys_days{date});
}

std::string DayClock::timeText(CivilDate date, Instant at) const {
    const long minutes = std::lround(minutesOf(date, at));
    const long ofDay = ((minutes % 1440) + 1440) % 1440;
    return minutes == 1440 ? "24:00" : fmt::format("{:02}:{:02}", ofDay / 60, ofDay % 60);
}

std::string DayClock::text() const {
    switch (settings_.kind) {
        case ClockKind::civil:
            return fillText(NM_TEXT("%1, with daylight saving"), {zone_.name()});
        case ClockKind::standard:
            return fillText(NM_TEXT("%1, standard time"), {zone_.name()});
        case ClockKind::fixed:
            return offsetText(settings_.offsetHours);
        case ClockKind::trueSolar:
            return localText(NM_TEXT("true solar time"));
    }
    return {};
}

}  // namespace noonmark
