#include "app/gui/view/time/sun_at_moment.h"

#include <QObject>
#include <array>
#include <cmath>

#include "core/sun/civil_time.h"
#include "core/sun/sun_events.h"

namespace noonmark {

namespace {

constexpr int minutesOfDay = 24 * 60;

int wallClock(const Zone& zone, Instant at) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(at);
    const auto local = (seconds.time_since_epoch() + zone.offsetAt(seconds)).count();
    const auto minutes = int(std::lround(double(local % 86400) / 60));
    return (minutes + minutesOfDay) % minutesOfDay;
}

QString quarterOf(double azimuthDeg) {
    const std::array names{QObject::tr("N"), QObject::tr("NE"), QObject::tr("E"), QObject::tr("SE"),
                           QObject::tr("S"), QObject::tr("SW"), QObject::tr("W"), QObject::tr("NW")};
    return names[std::size_t(std::lround(azimuthDeg / 45)) % names.size()];
}

}  // namespace

Result<SunAtMoment> computeSunAt(const Observer& observer, const Period& period, const TimeLook& look) {
    const auto zone = Zone::named(period.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const SolarPosition sun = computeSolarPosition(observer, zone->instantAt(look.date, look.at));
    const Degrees altitude = period.refraction ? sun.altitudeApparent : sun.altitude;
    SunAtMoment moment{.towards = observer.frameFromPlace * toDirection(sun.azimuth, altitude),
                       .azimuthDeg = sun.azimuth.value,
                       .altitudeDeg = altitude.value};
    const SunEvents events = computeSunEvents(observer, zone->instantAt(look.date, std::chrono::minutes(0)),
                                              SunriseRule::upperLimb);
    if (events.sunrise) moment.sunriseMin = wallClock(*zone, *events.sunrise);
    if (events.sunset) moment.sunsetMin = wallClock(*zone, *events.sunset);
    return moment;
}

Result<PresentLook> findPresentLook(const Observer& observer, const Period& period, Instant now) {
    const auto zone = Zone::named(period.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const CivilDate today = zone->dateAt(now);
    TimeLook look{LookSpan::moment, period.start.year() / today.month() / today.day(),
                  std::chrono::minutes(wallClock(*zone, now))};
    if (!look.date.ok()) look.date = look.date.year() / look.date.month() / std::chrono::last;
    const auto sun = computeSunAt(observer, period, look);
    if (!sun) return tl::make_unexpected(sun.error());
    if (!sun->isUp()) look.at = std::chrono::hours(12);
    return PresentLook{look, !sun->isUp()};
}

QString describe(const SunAtMoment& sun) {
    if (!sun.isUp()) return QObject::tr("Sun below the horizon");
    return QObject::tr("Sun %1° %2, %3° high")
        .arg(std::lround(sun.azimuthDeg) % 360)
        .arg(quarterOf(sun.azimuthDeg))
        .arg(std::lround(sun.altitudeDeg));
}

QString describeClock(int minutes) {
    return QStringLiteral("%1:%2")
        .arg(minutes / 60, 2, 10, QLatin1Char('0'))
        .arg(minutes % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace noonmark
