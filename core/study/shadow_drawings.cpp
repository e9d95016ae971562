#include "core/study/shadow_drawings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "core/base/progress.h"
#include "core/measures/outlines/day_isochrones.h"
#include "core/measures/places/place_run.h"
#include "core/measures/shadow_outlines.h"
#include "core/receivers/parcels/parcel_lines.h"
#include "core/receivers/place_names.h"
#include "core/study/prepare_review.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

namespace {

constexpr float drawingMarginM = 12;

std::vector<SunStep> stepsOf(const std::vector<DrawnTime>& times) {
    std::vector<SunStep> steps;
    for (const DrawnTime& time : times) steps.push_back(time.sun);
    return steps;
}

/// What differs between the two cities.
struct Changes {
    City proposal, removed;
};

Changes findChanges(const City& baseline, const City* scenario) {
    if (scenario == nullptr) return {};
    return {keepOwnBuildings(*scenario, baseline), keepOwnBuildings(baseline, *scenario)};
}

Box2 chooseArea(const City& baseline, const Changes& changes, const std::vector<Place>& places,
                const std::vector<SunStep>& steps, double longestM) {
    Box2 reach = boundShadows(changes.proposal, steps, longestM);
    if (const Box2 removed = boundShadows(changes.removed, steps, longestM); !removed.empty())
        reach.add(removed);
    if (reach.empty()) {
        const Box2 around = bounds(places);
        return around.empty() ? bounds(baseline) : around;
    }
    Box2 around = boundShadows(changes.proposal, {}, 0);
    around.add(boundShadows(changes.removed, {}, 0));
    for (const Place& place : choosePlacesIn(places, reach)) around.add(bounds(place));
    return places.empty() ? reach : Box2{glm::max(around.low, reach.low), glm::min(around.high, reach.high)};
}

Box2 widened(Box2 box) {
    box.low -= drawingMarginM;
    box.high += drawingMarginM;
    return box;
}

Result<std::vector<DrawnFan>> drawFans(const City& proposal, const std::vector<DrawnTime>& times,
                                       const OutlineSettings& settings, Progress& progress,
                                       const std::stop_token& stop) {
    std::vector<DrawnFan> fans;
    for (auto first = times.begin(); first != times.end();) {
        const auto end =
            std::find_if(first, times.end(), [&](const DrawnTime& time) { return time.day != first->day; });
        const std::vector<DrawnTime> ofDay(first, end);
        auto fan = outlineShadowFan(proposal, stepsOf(ofDay), settings, progress, stop);
        if (!fan) return tl::make_unexpected(fan.error());
        DrawnFan& drawn = fans.emplace_back(DrawnFan{first->day, {}, std::move(fan->all)});
        for (std::size_t i = 0; i < ofDay.size(); ++i)
            drawn.steps.push_back({ofDay[i], std::move(fan->ofStep[i])});
        first = end;
    }
    return fans;
}

void addAllBuildings(const City& baseline, const City* scenario, const Changes& changes,
                     ShadowDrawing& drawing) {
    const City unchanged =
        changes.removed.buildings.empty() ? baseline : keepOwnBuildings(baseline, changes.removed);
    addBuildings(unchanged, BuildingState::unchanged, drawing.area, drawing.buildings);
    if (scenario == nullptr) return;
    addBuildings(changes.proposal, BuildingState::proposed, drawing.area, drawing.buildings);
    addBuildings(changes.removed, BuildingState::removed, drawing.area, drawing.buildings);
}

std::vector<DrawnTime> timesOf(const std::vector<RuleMoment>& moments, const std::string& clock) {
    std::vector<DrawnTime> times;
    for (const RuleMoment& moment : moments) {
        const std::string day = formatText(moment.day);
        std::string digits = moment.clock;
        std::erase(digits, ':');
        times.push_back({fmt::format("{}_{}", day, digits), day,
                         fmt::format("{} {} {}", day, moment.clock, clock), moment.sun});
    }
    return times;
}

/// Lines of equal hours of a rule that asks for them, on its first days, with its distances from the places.
Result<void> addIsochrones(const ReviewStudy& study, const City& after, const Observer& observer,
                           const std::vector<Place>& places, ShadowDrawing& drawing, Progress& progress,
                           const std::stop_token& stop) {
    const Rule& rule = study.rule;
    const auto days = computeRuleSun(rule, {observer, study.settings.zone, study.year}, stop);
    if (!days) return tl::make_unexpected(days.error());
    const IsochroneSettings settings{drawing.area, listIsochroneMinutes(rule), planeOf(rule)};
    for (std::size_t day = 0; day < std::min(maxIsochroneDays, days->sun.days.size()); ++day) {
        auto lines =
            traceDayIsochrones(after, chooseDays(days->sun, std::array{day}), settings, progress, stop);
        if (!lines) return tl::make_unexpected(lines.error());
        drawing.isochrones.push_back(
            {formatText(days->sun.days[day].date), lines->cellM, std::move(lines->lines)});
    }
    if (!rule.receivers.hasLines()) return {};
    for (const double metres : {rule.receivers.innerLineM, rule.receivers.outerLineM}) {
        DrawnDistance& distance = drawing.distances.emplace_back(DrawnDistance{metres, {}});
        for (const Place& place : choosePlacesIn(places, drawing.area)) {
            auto belt = cutBelt(place.polygons, 0, metres);
            if (!belt) return tl::make_unexpected(belt.error());
            for (Footprint& polygon : *belt) distance.outlines.push_back({std::move(polygon.outer), {}});
        }
    }
    return {};
}

/// Buildings of the baseline that are drawn although the rule does not count their shadows, that is, those
/// not in `before`.
void addBuildingsWithoutShadow(const City& baseline, const City& scenario, const City& before,
                               ShadowDrawing& drawing) {
    const City silent = keepOwnBuildings(baseline, before);
    const City removed = keepOwnBuildings(silent, scenario);
    addBuildings(keepOwnBuildings(silent, removed), BuildingState::unchanged, drawing.area,
                 drawing.buildings);
    addBuildings(removed, BuildingState::removed, drawing.area, drawing.buildings);
}

/// The day of most incremental shadow on any place.
std::vector<std::chrono::month_day> worstDay(const ReviewStudy& study) {
    const PlaceReview* worst = nullptr;
    for (const PlaceReview& place : study.places)
        if (place.totals.largestDay &&
            (worst == nullptr || place.totals.incrementalM2h > worst->totals.incrementalM2h))
            worst = &place;
    if (worst == nullptr) return {};
    return {{worst->totals.largestDay->month(), worst->totals.largestDay->day()}};
}

}  // namespace

Result<ShadowDrawing> drawShadows(const City& baseline, const City* scenario,
                                  const std::vector<Place>& places, const std::vector<DrawnTime>& times,
                                  const DrawingSettings& settings, Progress& progress,
                                  const std::stop_token& stop) {
    const Changes changes = findChanges(baseline, scenario);
    const std::vector<SunStep> steps = stepsOf(times);
    ShadowDrawing drawing;
    drawing.frame = baseline.frame;
    drawing.area =
        settings.area.value_or(widened(chooseArea(baseline, changes, places, steps, settings.longestM)));
    const OutlineSettings outlining{drawing.area, settings.cellM, settings.planeM};
    ProgressShare share(progress, 0, 2);
    auto outlines = outlineShadows(baseline, scenario, steps, outlining, share, stop);
    if (!outlines) return tl::make_unexpected(outlines.error());
    for (std::size_t i = 0; i < times.size(); ++i)
        drawing.moments.push_back({times[i], std::move((*outlines)[i])});
    if (settings.withFans && !changes.proposal.buildings.empty()) {
        ProgressShare rest(progress, 1, 2);
        auto fans = drawFans(changes.proposal, times, outlining, rest, stop);
        if (!fans) return tl::make_unexpected(fans.error());
        drawing.fans = *std::move(fans);
    }
    drawing.places = choosePlacesIn(places, drawing.area);
    addAllBuildings(baseline, scenario, changes, drawing);
    return drawing;
}

Result<std::vector<RuleMoment>> computeReviewMoments(const ReviewStudy& study, const City& baseline,
                                                     int maxHoursADay, const std::stop_token& stop) {
    return computeRuleMoments(study.rule, {observerOfPlaces(baseline), study.settings.zone, study.year},
                              {.moreDays = worstDay(study), .maxHoursADay = maxHoursADay}, stop);
}

Result<ShadowDrawing> drawReviewShadows(const ReviewStudy& study, const City& baseline, const City& scenario,
                                        const std::vector<Place>& places, Progress& progress,
                                        const std::stop_token& stop) {
    const Rule& rule = study.rule;
    const auto moments = computeReviewMoments(study, baseline, 0, stop);
    if (!moments) return tl::make_unexpected(moments.error());
    const auto [before, after] = chooseCasters(rule, baseline, scenario);
    // The places of a rule with lines are parcels: what counts lies around them, as far as shadows reach.
    const std::vector<Place> none;
    const bool isAround = rule.receivers.hasLines();
    auto drawing = drawShadows(before, &after, isAround ? none : places, timesOf(*moments, study.clock),
                               {.cellM = study.settings.cellM, .planeM = planeOf(rule)}, progress, stop);
    if (!drawing) return tl::make_unexpected(drawing.error());
    if (isAround) drawing->places = choosePlacesIn(places, drawing->area);
    addBuildingsWithoutShadow(baseline, scenario, before, *drawing);
    if (hasIsochrones(rule)) {
        const auto done =
            addIsochrones(study, after, observerOfPlaces(baseline), places, *drawing, progress, stop);
        if (!done) return tl::make_unexpected(done.error());
    }
    drawing->notes.push_back("Rule: " + rule.name);
    if (const auto planeM = planeOf(rule))
        drawing->notes.push_back(
            fmt::format("Shadows are on a horizontal plane {:g} m above the mean ground", *planeM));
    return drawing;
}

}  // namespace noonmark
