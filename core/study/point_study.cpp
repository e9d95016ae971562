#include "core/study/point_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/progress.h"
#include "core/city/city_position.h"
#include "core/study/point_cases.h"

namespace noonmark {

namespace {

// Clockwise angle from the frame's +y to true north.
double convergenceDeg(const Observer& observer) {
    const glm::dvec3 north = observer.frameFromPlace * glm::dvec3(0, 1, 0);
    return Radians{std::atan2(north.x, north.y)}.degrees().value;
}

double degreesOfTan(double tan) { return Radians{std::atan(std::max(0.0, tan))}.degrees().value; }

/// Lists the skyline from true north on.
class SkylineList {
public:
    SkylineList(const Skyline& skyline, double northDeg) : skyline_(skyline), northDeg_(northDeg) {}

    void fill(PointView& view) {
        double at = 0;
        for (const SeenEdge& piece : skyline_.pieces()) {
            if (piece.from > at + 1e-9) addOpen(at, piece.from);
            addPiece(piece);
            at = piece.to;
        }
        if (at < fullTurn - 1e-9) addOpen(at, fullTurn);
        turn(places_);
        view.skyline = std::move(places_);
        view.stretches = std::move(stretches_);
    }

private:
    static double degrees(double azimuth) { return Radians{azimuth}.degrees().value; }

    void addOpen(double from, double to) {
        places_.push_back({degrees(from), 0});
        places_.push_back({degrees(to), 0});
    }

    void addPiece(const SeenEdge& piece) {
        const int parts = std::max(1, int(std::ceil(degrees(piece.to - piece.from))));
        for (int i = 0; i <= parts; ++i) {
            const double azimuth = piece.from + (piece.to - piece.from) * i / parts;
            places_.push_back({degrees(azimuth), degreesOfTan(piece.tanAt(azimuth))});
        }
        const double from = std::fmod(degrees(piece.from) - northDeg_ + 360, 360);
        const double to = std::fmod(degrees(piece.to) - northDeg_ + 360, 360);
        if (!stretches_.empty() && stretches_.back().building == piece.building &&
            std::abs(stretches_.back().toDeg - from) < 1e-6)
            stretches_.back().toDeg = to;
        else
            stretches_.push_back({from, to, piece.building});
    }

    // The frame's north is not true north: the list is turned, and begins at 0 and ends at 360 degrees again.
    void turn(std::vector<SkylinePlace>& places) const {
        for (SkylinePlace& place : places) place.azimuthDeg -= northDeg_;
        const auto split = northDeg_ > 0
                               ? std::ranges::find_if(places, [](auto p) { return p.azimuthDeg >= 0; })
                               : std::ranges::find_if(places, [](auto p) { return p.azimuthDeg > 360; });
        std::rotate(places.begin(), split, places.end());
        for (SkylinePlace& place : places) place.azimuthDeg = std::fmod(place.azimuthDeg + 720, 360);
        if (places.empty()) return;
        const double north =
            degreesOfTan(skyline_.tanAt(std::fmod(Degrees{northDeg_ + 360}.radians().value, fullTurn)));
        if (places.back().azimuthDeg == 0) places.pop_back();
        places.insert(places.begin(), {0, north});
        places.push_back({360, north});
    }

    const Skyline& skyline_;
    double northDeg_;
    std::vector<SkylinePlace> places_;
    std::vector<SkylineStretch> stretches_;
};

std::vector<OverhangSpan> listOverhangs(const Skyline& skyline, double northDeg) {
    std::vector<OverhangSpan> spans;
    if (skyline.faces().empty()) return spans;
    constexpr double widthDeg = 0.5;
    for (double from = 0; from < 360; from += widthDeg) {
        const double azimuth = Degrees{std::fmod(from + widthDeg / 2 + northDeg + 360, 360)}.radians().value;
        const double skylineTan = skyline.tanAt(azimuth);
        for (const HiddenAltitudes& hidden : skyline.hiddenAt(azimuth))
            if (hidden.highTan > skylineTan)
                spans.push_back({from, from + widthDeg, degreesOfTan(std::max(hidden.lowTan, skylineTan)),
                                 degreesOfTan(hidden.highTan)});
    }
    return spans;
}

/// The sun of the question's day: at steps, and at any instant.
struct SunOfDay {
    Observer observer;
    Ephemeris ephemeris;
    SunSteps steps;

    [[nodiscard]] std::optional<glm::vec3> directionAt(Instant at) const {
        const SolarPosition sun = ephemeris.at(at);
        if (sun.altitudeApparent.value <= 0) return std::nullopt;
        return glm::vec3(observer.frameFromPlace * toDirection(sun.azimuth, sun.altitudeApparent));
    }
};

std::vector<SunBand> findSunlitTimes(const Skyline& skyline, const SunOfDay& day) {
    auto bands = findSunBands(findShadedSteps(skyline, day.steps), day.steps, 0);
    refineSunBands(bands, day.steps.stepMinutes, [&](Instant at) {
        const auto direction = day.directionAt(at);
        return direction && !skyline.hides(*direction);
    });
    return bands;
}

// Between the sunlit times, each step with what hides the sun at its beginning.
std::vector<ShadedTime> findShadedTimes(const Skyline& skyline, const SunOfDay& day,
                                        const std::vector<SunBand>& sunlit) {
    std::vector<ShadedTime> times;
    const auto length = std::chrono::milliseconds(std::llround(day.steps.stepMinutes * 60000));
    std::int32_t slotBefore = -2;
    for (const SunStep& step : day.steps.steps) {
        const auto hider = skyline.findHider(step.direction);
        if (!hider) continue;
        const bool follows = !times.empty() && step.slot == slotBefore + 1;
        if (follows) times.back().when.to = step.at;  // beginnings of steps are rounded: no gap, no overlap
        if (follows && times.back().building == *hider)
            times.back().when.to = step.at + length;
        else
            times.push_back({{step.at, step.at + length}, *hider});
        slotBefore = step.slot;
    }
    // Sunlight begins within the step before a band's first lit step, and ends before the next shaded one.
    for (const SunBand& band : sunlit) {
        const auto after =
            std::ranges::find_if(times, [&](const ShadedTime& time) { return time.when.from >= band.to; });
        if (after != times.end() && after->when.from - band.to <= length) after->when.from = band.to;
        if (after != times.begin() && std::prev(after)->when.from < band.from)
            std::prev(after)->when.to = std::min(std::prev(after)->when.to, band.from);
    }
    return times;
}

PointView viewOf(const City& city, const SkyPoint& point, const PointStudy& study, const SunOfDay& day,
                 double northDeg, const Zone& zone) {
    const Skyline skyline = Skyline::at(point, collectSkyObstacles(city));
    PointView view;
    SkylineList(skyline, northDeg).fill(view);
    view.overhangs = listOverhangs(skyline, northDeg);
    view.factors = computeSkyFactors(skyline);
    view.shaded = findShadedSteps(skyline, study.sun);
    view.sunlit = findSunlitTimes(skyline, day);
    view.shadedTimes = findShadedTimes(skyline, day, view.sunlit);
    view.minutes = sumSunlight(view.shaded, study.sun, zone);
    view.year = countShadow(view.shaded, study.sun);
    view.crowns = lookAtCrowns(
        city, point, skyline, view.factors, northDeg, {study.sun, view.shaded},
        {day.steps, findShadedSteps(skyline, day.steps)}, [&](Instant at) { return day.directionAt(at); },
        zone);
    return view;
}

Period yearOf(const PointQuestion& question) {
    const auto year = question.day.year();
    return {.start = year / std::chrono::January / 1,
            .days = year.is_leap() ? 366 : 365,
            .stepMinutes = question.stepMinutes,
            .window = SolarHours{},
            .zone = question.zone};
}

Result<void> checkQuestion(const PointQuestion& question) {
    if (question.heightM && !(*question.heightM >= 0 && *question.heightM <= 2000))
        return failure(fmt::format("A height of {} m is out of range", *question.heightM), "point",
                       "Give 0 to 2000 m above the ground");
    if (!question.day.ok())
        return failure("The day does not exist", "point", "Give a date such as 2026-03-21");
    return {};
}

Result<SunOfDay> computeSunOfDay(const PointQuestion& question, const Zone& zone, const Observer& observer,
                                 const std::stop_token& stop) {
    const Period day{.start = question.day,
                     .days = 1,
                     .stepMinutes = std::min(1.0, question.stepMinutes),
                     .window = SolarHours{},
                     .zone = question.zone};
    auto steps = computeSunSteps(day, observer, stop);
    if (!steps) return tl::make_unexpected(steps.error());
    const Instant midnight = zone.instantAt(question.day, std::chrono::minutes(0));
    auto sun = Ephemeris::over(observer, midnight - std::chrono::days(1), midnight + std::chrono::days(2));
    if (!sun) return tl::make_unexpected(sun.error());
    return SunOfDay{observer, *std::move(sun), *std::move(steps)};
}

// Steps longer than a minute would miss the days on which little is lost, at the ends of a season.
Result<std::vector<SeasonOfLoss>> findSeasons(const City& baseline, const City& scenario,
                                              const SkyPoint& point, const PointStudy& study,
                                              const Observer& observer, const Zone& zone,
                                              const std::stop_token& stop) {
    if (study.question.stepMinutes <= 1)
        return findLosses(study.baseline.shaded, study.scenario->shaded, study.sun, zone);
    PointQuestion minutes = study.question;
    minutes.stepMinutes = 1;
    const auto sun = computeSunSteps(yearOf(minutes), observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    const auto shadedIn = [&](const City& city) {
        return findShadedSteps(Skyline::at(point, collectSkyObstacles(city)), *sun);
    };
    return findLosses(shadedIn(baseline), shadedIn(scenario), *sun, zone);
}

std::size_t dayNumber(CivilDate day) {
    const CivilDate first = day.year() / std::chrono::January / 1;
    return std::size_t((std::chrono::sys_days(day) - std::chrono::sys_days(first)).count());
}

}  // namespace

Result<PointStudy> runPointStudy(const City& baseline, const City* scenario, const PointQuestion& question,
                                 const std::stop_token& stop) {
    const Stopwatch watch;
    if (const auto ok = checkQuestion(question); !ok) return tl::make_unexpected(ok.error());
    const auto zone = Zone::named(question.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const glm::dvec2 place = baseline.frame.localFromLonLat(question.at);
    const Observer observer = placeObserver(baseline, place);
    const auto settled = settlePoint(baseline, question);
    if (!settled) return tl::make_unexpected(settled.error());
    if (scenario != nullptr)
        if (const auto there = settlePoint(*scenario, question);
            !there || there->point.position != settled->point.position)
            return failure("The scenario builds where the point is", question.zone.empty() ? "" : "point",
                           "Choose a point that exists in the baseline and in the scenario");
    auto sun = computeSunSteps(yearOf(question), observer, stop);
    if (!sun) return tl::make_unexpected(sun.error());
    PointStudy study{.question = question,
                     .position = settled->point.position,
                     .onRoof = settled->onRoof,
                     .possibleMin = sun->sunlitMinutes(),
                     .sun = *std::move(sun),
                     .day = dayNumber(question.day)};
    const auto day = computeSunOfDay(question, *zone, observer, stop);
    if (!day) return tl::make_unexpected(day.error());
    const double north = convergenceDeg(observer);
    study.baseline = viewOf(baseline, settled->point, study, *day, north, *zone);
    if (stop.stop_requested()) return cancelled();
    if (scenario != nullptr) {
        study.scenario = viewOf(*scenario, settled->point, study, *day, north, *zone);
        auto losses = findSeasons(baseline, *scenario, settled->point, study, observer, *zone, stop);
        if (!losses) return tl::make_unexpected(losses.error());
        study.losses = *std::move(losses);
    }
    study.seconds = watch.seconds();
    return study;
}

}  // namespace noonmark
