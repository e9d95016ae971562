#include "core/study/windows/window_study.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <set>

#include "core/base/memory_guard.h"
#include "core/base/stopwatch.h"
#include "core/engines/points/sky_factors.h"
#include "core/geo/earth_drop.h"
#include "core/measures/place_run.h"
#include "core/review/windows/window_points.h"
#include "core/study/elements/facing_azimuth.h"
#include "core/study/prepare_review.h"

namespace noonmark {

namespace {

/// The windows that are judged together, as indices of receivers.
using WindowGroup = std::vector<std::uint32_t>;

/// What the windows of all groups share.
struct WindowScene {
    const Rule& rule;
    const City& city;  ///< the scenario
    const PlacedElements& placed;
    const RuleSun& days;
    const ShadedStepFinder& after;
    const ShadedStepFinder* before;  ///< null: the baseline is the scenario
    std::optional<SkyTrees> sky, formerSky;
    std::set<std::uint32_t> fresh;  ///< buildings without former values, by index

    [[nodiscard]] bool hasFormer(std::uint32_t building) const { return !fresh.contains(building); }
    [[nodiscard]] PaneSize paneOf(std::uint32_t window) const {
        return placed.facts.empty() ? PaneSize{} : placed.facts[window].pane;
    }
};

bool isSameCity(const City& a, const City& b) {
    return &a == &b || (a.buildings == b.buildings && a.terrain == b.terrain);
}

/// Steps at which the sun does not come through the window at that point, whatever is outside.
ShadedSteps findTurnedAway(const PaneLimits& limits, const SunSteps& sun) {
    ShadedSteps away(sun.steps.size());
    for (std::size_t i = 0; i < away.size(); ++i)
        away[i] = limits.lets(glm::dvec3(sun.steps[i].direction)) ? 0 : 1;
    return away;
}

void shadeToo(ShadedSteps& shaded, const ShadedSteps& other) {
    for (std::size_t i = 0; i < shaded.size(); ++i) shaded[i] |= other[i];
}

void lightToo(ShadedSteps& shaded, const ShadedSteps& other) {
    for (std::size_t i = 0; i < shaded.size(); ++i) shaded[i] &= other[i];
}

/// The sun of one window: of both ends of a sill, where both are lit.
WindowSunlight measureWindow(const WindowScene& scene, std::uint32_t window) {
    const SurfacePoints& points = scene.placed.receivers.points;
    const RuleWindows& rule = scene.rule.receivers.windows;
    const SkyPoint middle{points.positions[window], points.normals[window]};
    const std::uint32_t building = scene.placed.receivers.elements[window].building;
    const SunSteps& sun = scene.days.sun;
    const PaneSize pane = scene.paneOf(window);
    WindowSunlight light;
    light.after.assign(sun.steps.size(), 0);
    if (scene.hasFormer(building)) light.before = light.after;
    for (const PanePoint& point : placePanePoints(rule, middle, pane)) {
        const ShadedSteps away = findTurnedAway(PaneLimits(rule, point, pane), sun);
        shadeToo(light.after, away);
        shadeToo(light.after, scene.after.find(point.point));
        if (!light.before || !scene.before) continue;
        shadeToo(*light.before, away);
        shadeToo(*light.before, scene.before->find(point.point));
    }
    if (light.before && !scene.before) light.before = light.after;
    return light;
}

void measureSky(const WindowScene& scene, std::uint32_t window, WindowSunlight& light) {
    if (!scene.sky) return;
    const SurfacePoints& points = scene.placed.receivers.points;
    const SkyPoint middle{points.positions[window], points.normals[window]};
    const auto point =
        placePanePoints(scene.rule.receivers.windows, middle, scene.paneOf(window)).front().point;
    light.skyComponentPct = computeSkyFactors(Skyline::at(point, *scene.sky)).skyComponentPct;
    light.formerSkyComponentPct =
        scene.formerSky && light.before
            ? computeSkyFactors(Skyline::at(point, *scene.formerSky)).skyComponentPct
            : light.skyComponentPct;
}

/// The sun of the windows of a group: where one of them is lit.
WindowSunlight measureGroup(const WindowScene& scene, const WindowGroup& group) {
    WindowSunlight light = measureWindow(scene, group.front());
    for (std::size_t i = 1; i < group.size(); ++i) {
        const WindowSunlight other = measureWindow(scene, group[i]);
        lightToo(light.after, other.after);
        if (light.before && other.before) lightToo(*light.before, *other.before);
    }
    measureSky(scene, group.front(), light);
    return light;
}

std::string nameOfUnit(const Rule& rule, const PlacedElements& placed, std::uint32_t window) {
    const WindowUnit unit = rule.receivers.windows.unit;
    if (placed.facts.empty() || unit == WindowUnit::window) return {};
    return unit == WindowUnit::room ? placed.facts[window].room : placed.facts[window].dwelling;
}

std::vector<WindowGroup> groupWindows(const Rule& rule, const PlacedElements& placed) {
    std::vector<WindowGroup> groups;
    std::map<std::pair<std::uint32_t, std::string>, std::size_t> named;
    for (std::uint32_t window = 0; window < placed.receivers.size(); ++window) {
        const std::string name = nameOfUnit(rule, placed, window);
        if (name.empty()) {
            groups.push_back({window});
            continue;
        }
        const auto [at, isNew] =
            named.try_emplace({placed.receivers.elements[window].building, name}, groups.size());
        if (isNew) groups.emplace_back();
        groups[at->second].push_back(window);
    }
    return groups;
}

ReviewedWindow describeGroup(const WindowScene& scene, const WindowGroup& group) {
    const std::uint32_t window = group.front();
    const PointElement& element = scene.placed.receivers.elements[window];
    ReviewedWindow described{.id = element.id, .floor = element.floor, .windows = int(group.size())};
    if (element.building < scene.city.buildings.size()) {
        described.building = scene.city.buildings[element.building]->sourceId;
        described.buildingName = scene.city.buildings[element.building]->name;
    }
    const std::string unit = nameOfUnit(scene.rule, scene.placed, window);
    if (!unit.empty())
        described.id = fmt::format("{}{}{}", described.building, described.building.empty() ? "" : " ", unit);
    const SurfacePoints& points = scene.placed.receivers.points;
    const LonLat place = scene.city.frame.lonLatFromLocal(glm::dvec2(points.positions[window]));
    const double azimuth = facingAzimuthDeg(scene.city.frame, place, points.normals[window]);
    if (std::isfinite(azimuth) && group.size() == 1) described.azimuthDeg = azimuth;
    return described;
}

glm::dvec3 placeOf(const City& city, glm::dvec3 position) {
    const LonLat place = city.frame.lonLatFromLocal(glm::dvec2(position));
    const double drop = city.terrain ? earthDropM(glm::dvec2(position)) : 0;
    return {place.lonDeg, place.latDeg, position.z + city.frame.originElevationM() + drop};
}

bool needsSky(const Rule& rule) {
    return std::ranges::any_of(rule.criteria,
                               [](const Criterion& c) { return c.measure == Measure::skyComponent; });
}

/// Facades carry a window of the rule's sizes in each bay.
ElementSettings withOpenings(const Rule& rule, ElementSettings elements) {
    const WindowOpening& opening = rule.receivers.windows.opening;
    FacadeSettings& facades = elements.facades;
    facades.aboveFloorM = std::min(facades.storeyM, opening.sillM + opening.heightM / 2);
    return elements;
}

Rule withinBays(Rule rule, const ElementSettings& elements) {
    double& width = rule.receivers.windows.opening.widthM;
    if (elements.places == ElementPlaces::facades) width = std::min(width, elements.facades.bayM);
    return rule;
}

void addAssumptions(const WindowStudy& study, const PlacedElements& placed, Warnings& warnings) {
    const auto unknown =
        std::ranges::count_if(placed.facts, [](const WindowFacts& facts) { return !facts.pane.isKnown(); });
    if (unknown == 0) return;
    const WindowOpening& opening = study.rule.receivers.windows.opening;
    warnings.push_back({WarningKind::assumed,
                        fmt::format("the size of the window is not stated; {:g} x {:g} m was taken",
                                    opening.widthM, opening.heightM),
                        fmt::format("{} windows", unknown)});
}

std::vector<std::string> listNotChecked(const Rule& rule, const City& city,
                                        const WindowReviewSettings& settings) {
    std::vector<std::string> all = rule.notChecked;
    if (!rule.occluders.terrain && city.terrain)
        all.emplace_back("The rule leaves terrain out; here terrain casts shadow");
    if (rule.occluders.trees) all.emplace_back("The rule counts trees; the city has none");
    if (settings.elements.places == ElementPlaces::facades)
        all.emplace_back("Where the windows are: one was assumed in each bay and storey of the facades");
    if (const FaceChoice& faces = settings.elements.faces; !faces.takesAll())
        all.push_back(fmt::format("Windows other than these: {}", describe(faces)));
    return all;
}

std::set<std::uint32_t> findFresh(const City& scenario, const City& baseline) {
    const City own = keepOwnBuildings(scenario, baseline);
    std::set<const Building*> changed;
    for (const auto& building : own.buildings) changed.insert(building.get());
    std::set<std::uint32_t> fresh;
    for (std::uint32_t i = 0; i < scenario.buildings.size(); ++i)
        if (changed.contains(scenario.buildings[i].get())) fresh.insert(i);
    return fresh;
}

void addPanes(const WindowScene& scene, const std::vector<WindowGroup>& groups, WindowStudy& study) {
    const PointReceivers& receivers = scene.placed.receivers;
    for (std::size_t unit = 0; unit < groups.size(); ++unit)
        for (const std::uint32_t window : groups[unit])
            study.panes.push_back({{glm::dvec3(receivers.points.positions[window]),
                                    glm::dvec3(receivers.points.normals[window]),
                                    sizeOrOpening(scene.rule.receivers.windows, scene.paneOf(window))},
                                   unit,
                                   receivers.elements[window].building});
}

Result<void> reviewAll(const WindowScene& scene, const std::vector<WindowGroup>& groups, WindowStudy& study,
                       Progress& progress, const std::stop_token& stop) {
    study.windows.resize(groups.size());
    study.places.resize(groups.size());
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        study.windows[i] = reviewWindow(scene.rule, scene.days, describeGroup(scene, groups[i]),
                                        measureGroup(scene, groups[i]));
        study.places[i] =
            placeOf(scene.city, glm::dvec3(scene.placed.receivers.points.positions[groups[i].front()]));
        progress.report(double(++done) / double(groups.size()), "evaluating windows");
    });
    if (stop.stop_requested()) return cancelled();
    return {};
}

void sumUp(WindowStudy& study) {
    study.buildings = reviewBuildings(study.rule, study.windows);
    for (const WindowReview& window : study.windows)
        study.windowChanges.add(window.formerVerdict, window.verdict);
    for (const BuildingReview& building : study.buildings)
        study.buildingChanges.add(building.formerVerdict, building.verdict);
}

Result<WindowStudy> answerWindows(const Rule& asked, const City& baseline, const City& scenario,
                                  const WindowReviewSettings& settings, Progress& progress,
                                  const std::stop_token& stop) {
    const Stopwatch whole;
    if (asked.receivers.surface != RuleSurface::windows)
        return unsupported("The rule is about places, not about windows", asked.key,
                           "Give places of the project (--places) to review");
    const Rule rule = withinBays(asked, settings.elements);
    auto days = computeRuleSun(rule, {observerOfPlaces(scenario), settings.zone, settings.year}, stop);
    if (!days) return tl::make_unexpected(days.error());
    if (days->sun.steps.empty())
        return failure("The sun is below the horizon in all hours of the rule", rule.key,
                       "Check place and year");
    StudySettings where;
    where.region = settings.region;
    auto placed = placeElements(scenario, where, withOpenings(rule, settings.elements), progress, stop);
    if (!placed) return tl::make_unexpected(placed.error());
    WindowStudy study{rule,
                      settings,
                      {},
                      {},
                      {},
                      {},
                      {},
                      {},
                      days->clock,
                      days->year,
                      days->sun.stepMinutes,
                      days->sun.steps.size(),
                      {},
                      listNotChecked(rule, scenario, settings),
                      {},
                      {}};
    const auto by =
        settings.by.value_or(days->sun.steps.size() <= mostTracedSteps ? ShadedStepFinder::By::rays
                                                                       : ShadedStepFinder::By::horizons);
    study.engine = by == ShadedStepFinder::By::rays ? "rays" : "horizons with ends by rays";
    study.warnings = placed->warnings;
    addAssumptions(study, *placed, study.warnings);
    study.seconds["prepare"] = whole.seconds();
    const Stopwatch watch;
    const bool same = isSameCity(baseline, scenario);
    const CastingCities casting = chooseCasters(rule, baseline, scenario);
    const auto after = ShadedStepFinder::over(casting.after, days->sun, by, stop);
    if (!after) return tl::make_unexpected(after.error());
    std::optional<ShadedStepFinder> before;
    if (!same) {
        auto found = ShadedStepFinder::over(casting.before, days->sun, by, stop);
        if (!found) return tl::make_unexpected(found.error());
        before = *std::move(found);
    }
    WindowScene scene{rule,  scenario, *placed,
                      *days, *after,   before ? &*before : nullptr,
                      {},    {},       findFresh(scenario, baseline)};
    if (needsSky(rule)) scene.sky.emplace(collectSkyObstacles(casting.after));
    if (needsSky(rule) && !same) scene.formerSky.emplace(collectSkyObstacles(casting.before));
    study.seconds["build"] = watch.seconds();
    const Stopwatch evaluation;
    const std::vector<WindowGroup> groups = groupWindows(rule, *placed);
    if (auto done = reviewAll(scene, groups, study, progress, stop); !done)
        return tl::make_unexpected(done.error());
    addPanes(scene, groups, study);
    sumUp(study);
    study.seconds["evaluate"] = evaluation.seconds();
    study.seconds["total"] = whole.seconds();
    return study;
}

}  // namespace

Result<WindowStudy> runWindowReview(const Rule& rule, const City& baseline, const City& scenario,
                                    const WindowReviewSettings& settings, Progress& progress,
                                    const std::stop_token& stop) {
    return guardMemory({.advice = "Choose fewer windows or buildings"},
                       [&] { return answerWindows(rule, baseline, scenario, settings, progress, stop); });
}

}  // namespace noonmark
