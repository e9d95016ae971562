#include "app/gui/view/time/sun_at_moment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/sun/civil_time.h"
#include "core/sun/sun_paths.h"
#include "render/scene/crown_bodies.h"

namespace noonmark {

/// What casts shadow at any moment.
struct MomentCasters {
    CasterFaces city;
    /// Crowns that are in leaf on the same days; none: always.
    struct Crowns {
        std::optional<LeafDays> days;
        CasterFaces faces;
    };
    std::vector<Crowns> crowns;
};

namespace {

std::shared_ptr<const MomentCasters> listCasters(const City& city, const std::stop_token& stop) {
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    MomentCasters casters{makeCasterFaces(city, all, stop), {}};
    if (!city.trees || stop.stop_requested())
        return std::make_shared<const MomentCasters>(std::move(casters));
    const CrownMeshes meshes = makeCrownMeshes(*city.trees);
    casters.crowns.push_back({std::nullopt, makeCasterFaces(meshes.evergreen)});
    for (const CrownMeshes::Losing& losing : meshes.losingLeaves)
        casters.crowns.push_back({losing.days, makeCasterFaces(losing.crowns)});
    return std::make_shared<const MomentCasters>(std::move(casters));
}

// Maps of one view have equal texels.
void addCrowns(const MomentCasters& casters, const SunView& view, const std::stop_token& stop,
               SunDepthMap& map) {
    for (const MomentCasters::Crowns& some : casters.crowns) {
        if (some.faces.faces.empty()) continue;
        const bool isBare = some.days && !some.days->inLeafOn(view.treeDay);
        const SunDepthMap own = drawSunDepths(some.faces, view.towardsSun, view.space, view.size, stop);
        std::vector<float>& depth = isBare ? map.bareCrowns : map.crowns;
        if (depth.empty()) depth.assign(own.depth.size(), std::numeric_limits<float>::lowest());
        std::ranges::transform(depth, own.depth, depth.begin(),
                               [](float a, float b) { return std::max(a, b); });
    }
}

}  // namespace

void SunShadow::setCity(std::shared_ptr<const City> city) {
    if (city == city_) return;
    slot_.drop();
    city_ = std::move(city);
    casters_.reset();
    ask();
}

void SunShadow::look(const std::optional<SunView>& view) {
    view_ = view;
    if (!view_) {
        slot_.drop();
        if (map_) {
            map_.reset();
            Q_EMIT changed();
        }
        return;
    }
    waiting_ = true;
    if (!slot_.busy()) ask();
}

void SunShadow::ask() {
    if (!city_ || !view_) return;
    waiting_ = false;
    slot_.start<Drawn>(
        tr("Drawing the shadow"),
        [city = city_, casters = casters_, view = *view_](Progress&,
                                                          const std::stop_token& stop) -> Result<Drawn> {
            Drawn drawn{casters ? casters : listCasters(*city, stop), nullptr};
            if (stop.stop_requested()) return cancelled();
            SunDepthMap map =
                drawSunDepths(drawn.casters->city, view.towardsSun, view.space, view.size, stop);
            if (view.treeDay > 0) addCrowns(*drawn.casters, view, stop, map);
            if (stop.stop_requested()) return cancelled();
            drawn.map = std::make_shared<const SunDepthMap>(std::move(map));
            return drawn;
        },
        [this](const Result<Drawn>& drawn) { take(drawn); });
}

void SunShadow::take(const Result<Drawn>& drawn) {
    if (!drawn || !view_) return;
    casters_ = drawn->casters;
    map_ = drawn->map;
    Q_EMIT changed();
    if (waiting_) ask();
}

namespace {

constexpr double readableAltitudeDeg = 10;  // shadows are five times as long as buildings are high

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

Result<SunAtMoment> computeSunAt(const Observer& observer, const Period& period, const ShownTime& look) {
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

Result<PresentTime> findPresentTime(const Observer& observer, const Period& period, Instant now) {
    const auto zone = Zone::named(period.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const CivilDate today = zone->dateAt(now);
    ShownTime look{ShownSpan::moment, period.start.year() / today.month() / today.day(),
                   std::chrono::minutes(wallClock(*zone, now))};
    if (!look.date.ok()) look.date = look.date.year() / look.date.month() / std::chrono::last;
    const auto sun = computeSunAt(observer, period, look);
    if (!sun) return tl::make_unexpected(sun.error());
    if (sun->altitudeDeg >= readableAltitudeDeg) return PresentTime{look};
    ShownTime noon = look;
    noon.at = std::chrono::hours(12);
    const auto atNoon = computeSunAt(observer, period, noon);
    const bool isLighter = !sun->isUp() || (atNoon && atNoon->altitudeDeg > sun->altitudeDeg);
    return isLighter ? PresentTime{noon, true} : PresentTime{look};
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
ShownTime laterToday(ShownTime look, const SunAtMoment& sun, int step) {
    const int first = sun.sunriseMin.value_or(0), last = sun.sunsetMin.value_or(lastMinute);
    const int next = int(look.at.count()) + step;
    const bool over = last > first && (next > last || next < first);
    look.at = minutes(over ? first : next % (lastMinute + 1));
    return look;
}

}  // namespace

ShownTime advance(const ShownTime& look, const SunAtMoment& sun, SunLoop loop, double seconds, double speed) {
    if (loop == SunLoop::day)
        return laterToday(look, sun, std::max(1, int(std::lround(60 * speed * seconds))));
    ShownTime later = look;
    const int step = std::max(1, int(std::lround(7 * speed * seconds)));
    later.date = dayOf(look.date.year(), (indexOf(look.date) + step) % daysIn(look.date.year()));
    return later;
}

ShownTime nudge(ShownTime look, int minutesLater, int daysLater) {
    look.at = minutes(std::clamp(int(look.at.count()) + minutesLater, 0, lastMinute));
    const auto year = look.date.year();
    look.date = dayOf(year, std::clamp(indexOf(look.date) + daysLater, 0, daysIn(year) - 1));
    return look;
}

}  // namespace noonmark
