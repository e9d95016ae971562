#include "core/study/glazing/glazing_study.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <map>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "core/engines/api/tree_shade.h"
#include "core/engines/points/sky_factors.h"
#include "core/engines/ray/surface_rays.h"
#include "core/measures/places/place_run.h"
#include "core/review/glazing/glazing_review.h"
#include "core/study/elements/element_map.h"
#include "core/study/prepare_review.h"

namespace noonmark {

namespace {

/// How some windows of a review by horizons differ from rays: steps in sun by one and in shadow by the other,
/// percent of all steps.
struct GlazingSample {
    std::size_t windows = 0;
    double offPct = 0;
};

/// What horizons with ends by rays aim at: only glimpses of a minute or so are missed.
inline constexpr double glazingErrorTargetPct = 0.05;

std::size_t countDifferent(const ShadedSteps& one, const ShadedSteps& other) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < one.size(); ++i) different += one[i] != other[i] ? 1 : 0;
    return different;
}

/// Traces the middles of up to 64 windows, evenly chosen, in the scenario. A stop leaves windows out. Some
/// 0.1 us a window and step.
GlazingSample sampleGlazing(const GlazingScene& scene, const std::stop_token& stop) {
    constexpr std::size_t maxSampled = 64;
    const SurfacePoints& points = scene.placed.receivers.points;
    const std::size_t count = std::min(points.size(), maxSampled);
    std::atomic<std::size_t> different{0};
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        if (stop.stop_requested()) return;
        const std::size_t window = i * points.size() / count;
        const SkyPoint point{points.positions[window], points.normals[window]};
        different += countDifferent(scene.after->find(point), scene.after->trace(point));
    });
    const double steps = double(count) * double(scene.days.sun.steps.size());
    return {count, steps > 0 ? 100 * double(different) / steps : 0};
}

/// "horizons of 64 windows are off by 1.203 % of the steps"
std::string describe(const GlazingSample& sample) {
    return fmt::format("horizons of {} are off by {:.3f} % of the steps", countOf(sample.windows, "window"),
                       sample.offPct);
}

// Trees that the rule does not count are no difference.
bool isSameCity(const City& a, const City& b, const CastingCities& casting) {
    return &a == &b || (a.buildings == b.buildings && a.terrain == b.terrain &&
                        haveSameTrees(casting.before, casting.after));
}

/// Steps at which the sun does not come through the window at that point, whatever is outside.
ShadedSteps findTurnedAway(const PaneLimits& limits, const SunSteps& sun) {
    ShadedSteps away(sun.steps.size());
    for (std::size_t i = 0; i < away.size(); ++i)
        away[i] = limits.admits(glm::dvec3(sun.steps[i].direction)) ? 0 : 1;
    return away;
}

void shadeToo(ShadedSteps& shaded, const ShadedSteps& other) {
    for (std::size_t i = 0; i < shaded.size(); ++i) shaded[i] |= other[i];
}

/// Of both ends of a sill: what the darker one has.
void takeLess(SunShares& shares, const SunShares& other) {
    for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = std::min(shares[i], other[i]);
}

/// Of the windows of a room: what the brighter one has.
void takeMore(SunShares& shares, const SunShares& other) {
    for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = std::max(shares[i], other[i]);
}

/// Of a point that something solid hides from the sun at `shaded`.
SunShares findSunShares(const GlazingScene& scene, const CrownScene& crowns, const SkyPoint& point,
                        const ShadedSteps& shaded) {
    SunShares shares(shaded.size());
    CrownsOverPoint over(crowns.crowns, *scene.patches, crowns.phases);
    const bool any = over.begin(glm::dvec3(placeSurfaceRayOrigin(point.position, point.normal)));
    for (std::size_t i = 0; i < shaded.size(); ++i) {
        if (shaded[i] != 0) continue;
        shares[i] = any ? float(1 - over.at(i).takenShare(crowns.inLeaf[i] != 0)) : 1;
    }
    return shares;
}

/// Puts into shadow the steps at which crowns take as much as counts as shadow.
void shadeByCrowns(ShadedSteps& shaded, const SunShares& shares) {
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (1 - shares[i] >= float(TreeShade::defaultShadedFrom)) shaded[i] = 1;
}

void lightToo(ShadedSteps& shaded, const ShadedSteps& other) {
    for (std::size_t i = 0; i < shaded.size(); ++i) shaded[i] &= other[i];
}

/// One of the two cities that windows are measured in.
struct GlazingCity {
    const ShadedStepFinder& finder;
    const std::optional<GlazingCrowns>& crowns;
};

/// Adds what a point of a window has to that of its other points.
void addPoint(const GlazingScene& scene, const GlazingCity& city, const SkyPoint& point,
              const ShadedSteps& away, ShadedSteps& shaded, SunShares& shares) {
    ShadedSteps here = city.finder.find(point);
    shadeToo(here, away);
    if (city.crowns && !city.crowns->sunward.empty()) {
        SunShares ofPoint = findSunShares(scene, city.crowns->sunward, point, here);
        shadeByCrowns(here, ofPoint);
        if (!shares.empty()) takeLess(ofPoint, shares);
        shares = std::move(ofPoint);
    }
    shadeToo(shaded, here);
}

/// The sun of one window: of both ends of a sill, where both are lit.
GlazingSunlight measureWindow(const GlazingScene& scene, std::uint32_t window) {
    const SurfacePoints& points = scene.placed.receivers.points;
    const RuleGlazing& rule = scene.rule.receivers.glazing;
    const SkyPoint middle{points.positions[window], points.normals[window]};
    const std::uint32_t building = scene.placed.receivers.elements[window].building;
    const SunSteps& sun = scene.days.sun;
    const PaneSize pane = scene.paneOf(window);
    GlazingSunlight light;
    light.after.assign(sun.steps.size(), 0);
    if (!scene.newBuildings.contains(building)) light.before = light.after;
    for (const PanePoint& point : placePanePoints(rule, middle, pane)) {
        const ShadedSteps away = findTurnedAway(PaneLimits(rule, point, pane), sun);
        addPoint(scene, {*scene.after, scene.crowns}, point.point, away, light.after, light.shares);
        if (!light.before || !scene.before) continue;
        addPoint(scene, {*scene.before, scene.formerCrowns}, point.point, away, *light.before,
                 light.formerShares);
    }
    if (light.before && !scene.before) {
        light.before = light.after;
        light.formerShares = light.shares;
    }
    return light;
}

double computeSkyComponent(const SkyPoint& point, const SkyTrees& sky,
                           const std::optional<GlazingCrowns>& crowns) {
    const Skyline skyline = Skyline::at(point, sky);
    const double without = computeSkyFactors(skyline).skyComponentPct;
    return crowns ? std::max(0.0, without - crowns->sky.takenPct(point, skyline)) : without;
}

void measureSky(const GlazingScene& scene, std::uint32_t window, GlazingSunlight& light) {
    if (!scene.sky) return;
    const SurfacePoints& points = scene.placed.receivers.points;
    const SkyPoint middle{points.positions[window], points.normals[window]};
    const auto point =
        placePanePoints(scene.rule.receivers.glazing, middle, scene.paneOf(window)).front().point;
    light.skyComponentPct = computeSkyComponent(point, *scene.sky, scene.crowns);
    light.formerSkyComponentPct = scene.formerSky && light.before
                                      ? computeSkyComponent(point, *scene.formerSky, scene.formerCrowns)
                                      : light.skyComponentPct;
}

/// The sun of the windows of a group: where one of them is lit.
GlazingSunlight measureGroup(const GlazingScene& scene, const GlazingGroup& group) {
    GlazingSunlight light = measureWindow(scene, group.front());
    for (std::size_t i = 1; i < group.size(); ++i) {
        const GlazingSunlight other = measureWindow(scene, group[i]);
        lightToo(light.after, other.after);
        takeMore(light.shares, other.shares);
        if (!light.before || !other.before) continue;
        lightToo(*light.before, *other.before);
        takeMore(light.formerShares, other.formerShares);
    }
    measureSky(scene, group.front(), light);
    return light;
}

std::string nameOfUnit(const Rule& rule, const PlacedElements& placed, std::uint32_t window) {
    const GlazingUnit unit = rule.receivers.glazing.unit;
    if (placed.facts.empty() || unit == GlazingUnit::window) return {};
    return unit == GlazingUnit::room ? placed.facts[window].room : placed.facts[window].dwelling;
}

std::vector<GlazingGroup> groupGlazing(const Rule& rule, const PlacedElements& placed) {
    std::vector<GlazingGroup> groups;
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

ReviewedGlazing describeGroup(const GlazingScene& scene, const GlazingGroup& group) {
    const std::uint32_t window = group.front();
    const PointElement& element = scene.placed.receivers.elements[window];
    ReviewedGlazing described{.id = element.id, .floor = element.floor, .windows = int(group.size())};
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

bool needsSky(const Rule& rule) {
    return std::ranges::any_of(rule.criteria,
                               [](const Criterion& c) { return c.measure == Measure::skyComponent; });
}

/// Facades carry a window of the rule's sizes in each bay.
ElementSettings withOpenings(const Rule& rule, ElementSettings elements) {
    const GlazingOpening& opening = rule.receivers.glazing.opening;
    FacadeSettings& facades = elements.facades;
    facades.aboveFloorM = std::min(facades.storeyM, opening.sillM + opening.heightM / 2);
    return elements;
}

Rule withinBays(Rule rule, const ElementSettings& elements) {
    double& width = rule.receivers.glazing.opening.widthM;
    if (elements.places == ElementPlaces::facades) width = std::min(width, elements.facades.bayM);
    return rule;
}

std::set<std::uint32_t> findNewBuildings(const City& scenario, const City& baseline) {
    const City own = keepOwnBuildings(scenario, baseline);
    std::set<const Building*> changed;
    for (const auto& building : own.buildings) changed.insert(building.get());
    std::set<std::uint32_t> fresh;
    for (std::uint32_t i = 0; i < scenario.buildings.size(); ++i)
        if (changed.contains(scenario.buildings[i].get())) fresh.insert(i);
    return fresh;
}

Result<void> placeGlazing(GlazingScene& scene, const GlazingReviewSettings& settings, Progress& progress,
                          const std::stop_token& stop) {
    StudySettings where;
    where.region = settings.region;
    auto placed =
        placeElements(scene.city, where, withOpenings(scene.rule, settings.elements), progress, stop);
    if (!placed) return tl::make_unexpected(placed.error());
    scene.placed = *std::move(placed);
    scene.groups = groupGlazing(scene.rule, scene.placed);
    return {};
}

Result<std::optional<ShadedStepFinder>> makeFinder(const GlazingScene& scene, const City& casters,
                                                   const std::stop_token& stop) {
    return ShadedStepFinder::over(casters, scene.days.sun, scene.by, stop).map([](ShadedStepFinder finder) {
        return std::optional(std::move(finder));
    });
}

void findGlazingCrowns(GlazingScene& scene, const CastingCities& casting, bool same) {
    if (!casting.before.trees && !casting.after.trees) return;
    const SurfacePoints& windows = scene.placed.receivers.points;
    scene.patches.emplace(scene.days.sun);
    if (casting.after.trees) scene.crowns.emplace(casting.after, windows, scene.days.sun);
    if (casting.before.trees && !same) scene.formerCrowns.emplace(casting.before, windows, scene.days.sun);
}

Result<void> buildScene(GlazingScene& scene, const City& baseline, const std::stop_token& stop) {
    const Stopwatch watch;
    const CastingCities casting = chooseCasters(scene.rule, baseline, scene.city);
    const bool same = isSameCity(baseline, scene.city, casting);
    scene.trees = describeCountedTrees(scene.rule.occluders.trees, scene.city, baseline);
    findGlazingCrowns(scene, casting, same);
    auto after = makeFinder(scene, casting.after, stop);
    if (!after) return tl::make_unexpected(after.error());
    scene.after = *std::move(after);
    auto before = same ? std::optional<ShadedStepFinder>() : makeFinder(scene, casting.before, stop);
    if (!before) return tl::make_unexpected(before.error());
    scene.before = *std::move(before);
    scene.newBuildings = findNewBuildings(scene.city, baseline);
    if (needsSky(scene.rule)) scene.sky.emplace(collectSkyObstacles(casting.after));
    if (needsSky(scene.rule) && !same) scene.formerSky.emplace(collectSkyObstacles(casting.before));
    scene.engine =
        scene.by == ShadedStepFinder::By::rays ? NM_TEXT("rays") : NM_TEXT("horizons with ends by rays");
    scene.buildSeconds = watch.seconds();
    return {};
}

// Left to itself, a review by horizons goes on to rays where some of its windows show that horizons are off.
Result<void> checkHorizons(GlazingScene& scene, const std::stop_token& stop) {
    const Stopwatch watch;
    const GlazingSample sample = sampleGlazing(scene, stop);
    if (stop.stop_requested()) return cancelled();
    if (sample.offPct > glazingErrorTargetPct) {
        scene.engine = fmt::format("rays, since {}, more than the {:g} % aimed at", describe(sample),
                                   glazingErrorTargetPct);
        scene.by = ShadedStepFinder::By::rays;
        scene.after->switchToRays();
        if (scene.before) scene.before->switchToRays();
    }
    scene.buildSeconds += watch.seconds();
    return {};
}

}  // namespace

Result<std::unique_ptr<const GlazingScene>> prepareGlazingScene(const Rule& rule, const City& baseline,
                                                                const City& scenario,
                                                                const GlazingReviewSettings& settings,
                                                                Progress& progress,
                                                                const std::stop_token& stop) {
    if (rule.receivers.surface != RuleSurface::windows)
        return unsupported("The rule is about places, not about windows", rule.key,
                           fmt::format("Give places of the project ({}) to review", flags::places));
    const Stopwatch watch;
    auto days = computeRuleSun(rule, {observerOfPlaces(scenario), settings.zone, settings.year}, stop);
    if (!days) return tl::make_unexpected(days.error());
    std::unique_ptr<GlazingScene> scene(
        new GlazingScene{withinBays(rule, settings.elements), scenario, {}, *std::move(days)});
    if (const auto placed = placeGlazing(*scene, settings, progress, stop); !placed)
        return tl::make_unexpected(placed.error());
    scene->prepareSeconds = watch.seconds();
    const bool few = scene->days.sun.steps.size() <= maxTracedSteps;
    scene->by = settings.by.value_or(few ? ShadedStepFinder::By::rays : ShadedStepFinder::By::horizons);
    if (const auto built = buildScene(*scene, baseline, stop); !built)
        return tl::make_unexpected(built.error());
    if (!settings.by && !few)
        if (const auto checked = checkHorizons(*scene, stop); !checked)
            return tl::make_unexpected(checked.error());
    return scene;
}

GlazingReview reviewGroup(const GlazingScene& scene, const GlazingGroup& group) {
    return reviewGlazing(scene.rule, scene.days, describeGroup(scene, group), measureGroup(scene, group));
}

}  // namespace noonmark
