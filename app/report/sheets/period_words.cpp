#include "app/report/sheets/period_words.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace noonmark {

namespace {

QString describeClock(double minutes) {
    const long whole = std::lround(minutes);
    return QString::fromStdString(fmt::format("{:02}:{:02}", whole / 60, whole % 60));
}

/// "sunrise", "sunrise + 90 min", "sunrise - 10 min"
QString describeSun(const QString& event, long minutesLater) {
    if (minutesLater == 0) return event;
    const QString sign = minutesLater > 0 ? QStringLiteral(" + %1 min") : QStringLiteral(" - %1 min");
    return event + sign.arg(std::abs(minutesLater));
}

QString describeSolarHours(const SolarHours& window) {
    return describeSun(QStringLiteral("sunrise"), long(window.afterSunrise.count())) +
           QStringLiteral(" to ") + describeSun(QStringLiteral("sunset"), -long(window.beforeSunset.count()));
}

QString describeWallClock(const Period& period) {
    const double from = double(period.from.count());
    const double until = from + period.hours * 60;
    if (until <= 24 * 60) return describeClock(from) + QStringLiteral(" to ") + describeClock(until);
    return QStringLiteral("%1 for %2 h").arg(describeClock(from)).arg(period.hours);
}

}  // namespace

QString describeDates(CivilDate date) {
    static constexpr std::array months{"January", "February", "March",     "April",   "May",      "June",
                                       "July",    "August",   "September", "October", "November", "December"};
    if (!date.ok()) return QStringLiteral("no date");
    return QString::fromStdString(
        fmt::format("{} {} {}", unsigned(date.day()), months[unsigned(date.month()) - 1], int(date.year())));
}

QString describeDays(const Period& period) {
    if (period.days == 1 || !period.start.ok()) return describeDates(period.start);
    const CivilDate last = std::chrono::sys_days(period.start) + std::chrono::days(period.days - 1);
    return QStringLiteral("%1 to %2 (%3 days)")
        .arg(describeDates(period.start), describeDates(last))
        .arg(period.days);
}

QString describeHours(const Period& period) {
    if (!period.window && period.hours == 0)
        return QStringLiteral("at ") + describeClock(double(period.from.count()));
    const QString hours = period.window ? describeSolarHours(*period.window) : describeWallClock(period);
    return hours + QStringLiteral(", every %1 min").arg(period.stepMinutes);
}

QString describePeriod(const Period& period) {
    return QStringLiteral("%1, %2, %3")
        .arg(describeDays(period), describeHours(period), QString::fromStdString(period.zone));
}

}  // namespace noonmark
