#include "core/study/review_study.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/safe_text.h"
#include "core/city/trees/tree.h"
#include "core/describe/text.h"
#include "core/engines/auto_engine.h"
#include "core/engines/ray/tree_rays.h"
#include "core/engines/trees/crowns_around.h"
#include "core/measures/places/place_run.h"
#include "core/measures/places/place_sums.h"
#include "core/review/criteria/worst_spots.h"
#include "core/study/prepare_review.h"

namespace noonmark {

std::vector<std::string> listUnchecked(const Rule& rule, const City& city) {
    std::vector<std::string> all = rule.notChecked;
    if (!city.terrain)
        all.emplace_back(NM_TEXT("Slopes: there is no terrain, so the ground is taken as flat"));
    if (!rule.occluders.terrain && city.terrain)
        all.emplace_back(NM_TEXT("The rule leaves terrain out; here terrain casts shadow"));
    return all;
}

namespace {

/// Thins the steps of a day, so that a year of them stays small.
DayTimeline thinned(DayTimeline day, double stepMinutes, std::size_t days) {
    constexpr std::size_t maxDays = 31;
    constexpr double minMinutes = 10;
    if (days <= maxDays) return day;
    const auto every = std::max(std::size_t{1}, std::size_t(std::ceil(minMinutes / stepMinutes)));
    std::vector<PlaceStep> steps;
    for (std::size_t i = 0; i < day.steps.size(); i += every) steps.push_back(day.steps[i]);
    day.steps = std::move(steps);
    return day;
}

// A scenario that changes nothing passes, which says nothing about a proposal.
bool areSame(const Rule& rule, const City& baseline, const City& scenario) {
    return baseline.buildings == scenario.buildings &&
           (rule.occluders.trees == RuleTrees::without || haveSameTrees(baseline, scenario));
}

std::vector<std::string> notCheckedIn(const Rule& rule, const City& city) {
    std::vector<std::string> all = listUnchecked(rule, city);
    if (rule.receivers.surface == RuleSurface::plane && city.terrain)
        all.emplace_back("The mean ground is the mean of the ground that is measured");
    return all;
}

/// The shadow that one building alone adds to what is lit in the baseline, m2 x h by place.
Result<std::vector<double>> shadowOfBuilding(const PreparedReview& prepared, const Building& building,
                                             const Engine& engine, Progress& progress,
                                             const std::stop_token& stop) {
    City without = prepared.scene.after;
    std::erase_if(without.buildings, [&](const auto& other) { return other.get() == &building; });
    std::vector<double> incremental(prepared.measured.places.size());
    const auto take = [&](std::size_t day, std::span<const PlaceShadow> shadows) -> Result<void> {
        tbb::parallel_for(std::size_t{0}, shadows.size(), [&](std::size_t i) {
            const DayTimeline timeline = computeTimeline(shadows[i], {.steps = false, .longestStays = false});
            incremental[i] += prepared.days.weights[day] * timeline.incremental.areaHoursM2;
        });
        return {};
    };
    return shadeWithout(engine, prepared, without, take, progress, stop).map([&] {
        return std::move(incremental);
    });
}

/// Contributions of scenarios with several new buildings; of too many, a warning instead.
Result<void> addContributions(const PreparedReview& prepared, const Engine& engine, Progress& progress,
                              const std::stop_token& stop, ReviewStudy& study) {
    const City fresh = keepOwnBuildings(prepared.scene.after, prepared.scene.before);
    if (fresh.buildings.size() < 2) return {};
    if (fresh.buildings.size() > maxContributors) {
        study.warnings.push_back({WarningKind::leftOut, "contributions of single new buildings",
                                  fmt::format("{} new buildings; at most {} are computed one by one",
                                              fresh.buildings.size(), maxContributors)});
        return {};
    }
    for (std::size_t i = 0; i < fresh.buildings.size(); ++i) {
        ProgressShare share(progress, i, fresh.buildings.size());
        const Building& building = *fresh.buildings[i];
        auto incremental = shadowOfBuilding(prepared, building, engine, share, stop);
        if (!incremental) return tl::make_unexpected(incremental.error());
        study.contributions.push_back({building.sourceId, building.name, *std::move(incremental)});
    }
    return {};
}

/// Looks for the worst spots of places between the centres of their cells; for none where not wanted.
struct SpotFinder {
    std::vector<SpotSearch> searches;
    std::optional<PlacePoints> points;

    [[nodiscard]] std::vector<PlaceShadow> near(std::size_t place, const PlaceShadow& shadow) const {
        if (!points) return {};
        return refineWorstSpots(place, shadow, *points, searches);
    }
};

Result<SpotFinder> prepareSpots(const Rule& rule, const PreparedReview& prepared,
                                const ReviewSettings& settings, const std::stop_token& stop) {
    SpotFinder finder{listSpotSearches(rule), {}};
    if (!settings.refinesSpots) return finder;
    const RuleScene& scene = prepared.scene;
    std::vector<const City*> cities{&scene.before, &scene.after};
    if (scene.bare) cities.push_back(&*scene.bare);
    auto points = PlacePoints::over(cities, prepared.measured.places, scene.receivers, scene.planeZ,
                                    prepared.days.sun, stop);
    if (!points) return tl::make_unexpected(points.error());
    finder.points = *std::move(points);
    return finder;
}

/// Rays at the points around the worst spots of each place, at every step in each city. In packets of a
/// day's steps they take a third of the time of single rays: measured on places of Chicago's Loop, 15 ns on
/// one of two busy cores.
double estimateSpotSeconds(const Rule& rule, const PreparedReview& prepared) {
    constexpr double secondsOfRay = 10e-9;  // two cores
    const double cities = prepared.scene.bare ? 3 : 2;
    return double(expectSpotPoints(rule, prepared)) * double(prepared.days.sun.steps.size()) * cities *
           secondsOfRay;
}

// Of the masks of one city: the crowns near each half degree of a day's sun, at each cell (CrownMasks).
double estimateCrownSeconds(const City& city, const Receivers& receivers, const SunSteps& sun) {
    constexpr double secondsOfChord = 10e-9 / 2;  // two cores
    const CrownScene crowns = findCrowns(city, receivers, sun);
    if (crowns.empty()) return 0;
    std::size_t patches = 0;
    for (const SunDay& day : sun.days)
        patches += SunPatches(std::span(sun.steps).subspan(day.first, day.count)).count();
    return double(receivers.cells.size()) * double(patches) * countCrownsAtRays(crowns, receivers, sun) *
           secondsOfChord;
}

}  // namespace

Result<double> estimateReviewSeconds(const Rule& rule, const City& baseline, const City& scenario,
                                     const std::vector<Place>& places, const ReviewSettings& settings,
                                     const std::stop_token& stop) {
    const auto prepared = prepareReview(rule, baseline, scenario, places, settings, stop);
    if (!prepared) return tl::make_unexpected(prepared.error());
    const auto cities = prepared->scene.cities();
    const EngineLoad load = measureEngineLoad(cities, prepared->scene.receivers.receivers, prepared->days.sun,
                                              HorizonSweepSettings());
    const EstimatedSeconds one = estimateSeconds(load);
    // Shadow at each cell and step is weighed, and its runs are counted.
    constexpr double secondsOfCell = 0.5e-9;  // two cores; measured likewise
    const double weighing = double(load.receivers) * double(load.steps) * secondsOfCell;
    double fields = double(cities.size()) * ((load.level ? one.projected : one.ray) + weighing);
    for (const City* city : cities)
        fields += estimateCrownSeconds(*city, prepared->scene.receivers.receivers, prepared->days.sun);
    return fields + (settings.refinesSpots ? estimateSpotSeconds(rule, *prepared) : 0);
}

Result<RuleTimelines> computeRuleTimelines(const Rule& rule, const City& baseline, const City& scenario,
                                           const std::vector<Place>& places, const ReviewSettings& settings,
                                           const Engine& engine, Progress& progress, std::stop_token stop) {
    const auto prepared = prepareReview(rule, baseline, scenario, places, settings, stop);
    if (!prepared) return tl::make_unexpected(prepared.error());
    const RuleSun& days = prepared->days;
    const RulePlaces& measured = prepared->measured;
    RuleTimelines timelines{{}, {}, days.clock, days.sun.stepMinutes};
    for (const Place& place : measured.places) timelines.names.push_back(place.name);
    timelines.days.resize(measured.places.size());
    const auto spots = prepareSpots(rule, *prepared, settings, stop);
    if (!spots) return tl::make_unexpected(spots.error());
    // With the spots between cells, as the rows of a review: both state the same times.
    const auto take = [&](std::size_t, std::span<const PlaceShadow> shadows) -> Result<void> {
        for (std::size_t i = 0; i < shadows.size(); ++i) {
            const auto between = spots->near(i, shadows[i]);
            timelines.days[i].push_back(
                computeTimeline(shadows[i], {.longestStays = false, .spots = between}));
        }
        return {};
    };
    return shadeScene(engine, *prepared, take, progress, std::move(stop)).map([&] {
        return std::move(timelines);
    });
}

Result<ReviewStudy> runReview(const Rule& rule, const City& baseline, const City& scenario,
                              const std::vector<Place>& places, const ReviewSettings& settings,
                              const Engine& engine, Progress& progress, std::stop_token stop) {
    const auto prepared = prepareReview(rule, baseline, scenario, places, settings, stop);
    if (!prepared) return tl::make_unexpected(prepared.error());
    const RuleSun& days = prepared->days;
    const RulePlaces& measured = prepared->measured;
    const RuleScene& scene = prepared->scene;
    const auto spots = prepareSpots(rule, *prepared, settings, stop);
    if (!spots) return tl::make_unexpected(spots.error());
    std::vector<PlaceEvaluation> evaluations;
    for (std::size_t i = 0; i < measured.places.size(); ++i)
        evaluations.emplace_back(rule, days.clock, measured.places[i].name, measured.places[i].kind, 0,
                                 measured.belts[i]);
    std::vector<std::vector<DayTimeline>> timelines(settings.timelines ? measured.places.size() : 0);
    const auto take = [&](std::size_t day, std::span<const PlaceShadow> shadows) -> Result<void> {
        tbb::parallel_for(std::size_t{0}, shadows.size(), [&](std::size_t i) {
            const auto between = spots->near(i, shadows[i]);
            evaluations[i].add(shadows[i], days.weights[day], between);
            if (settings.timelines)
                timelines[i].push_back(
                    thinned(computeTimeline(shadows[i], {.longestStays = false, .spots = between}),
                            days.sun.stepMinutes, days.sun.days.size()));
        });
        return {};
    };
    ProgressShare first(progress, 0, settings.contributions ? 2 : 1);
    const auto done = shadeScene(engine, *prepared, take, first, stop);
    if (!done) return tl::make_unexpected(done.error());
    ReviewStudy study{
        rule,
        settings,
        {},
        std::move(timelines),
        {},
        std::string(engine.stepMaskEngineName(scene.cities(), scene.receivers.receivers)),
        days.clock.text(),
        days.year,
        days.sun.stepMinutes,
        settings.refinesSpots ? std::optional(spotDistanceCells * settings.cellM) : std::nullopt,
        notCheckedIn(rule, baseline),
        {}};
    study.trees = describeCountedTrees(rule.occluders.trees, scenario, baseline);
    study.warnings = days.warnings;
    if (areSame(rule, baseline, scenario))
        study.warnings.push_back({WarningKind::assumed,
                                  "the scenario changes nothing: it has the buildings of the baseline",
                                  rule.key});
    for (const PlaceEvaluation& evaluation : evaluations) study.places.push_back(evaluation.finish());
    if (!settings.contributions) return study;
    ProgressShare second(progress, 1, 2);
    return addContributions(*prepared, engine, second, stop, study).map([&] { return std::move(study); });
}

}  // namespace noonmark
