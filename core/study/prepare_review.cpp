#include "core/study/prepare_review.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/receivers/parcels/parcel_lines.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/elements/element_fields.h"

namespace noonmark {

namespace {

double highestM(const City& city) {
    double highest = 0;
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts) highest = std::max(highest, double(part.topM));
    return highest;
}

/// The least limit of the rule's criteria beyond the outer line, minutes.
double minLimitBeyond(const Rule& rule) {
    double minimum = 1440;
    for (const Criterion& criterion : rule.criteria)
        for (const Limit& limit : criterion.limits)
            if (criterion.belt == LineBelt::beyondLines && !limit.ofFormer)
                minimum = std::min(minimum, limit.value);
    return minimum;
}

/// How far from the parcel a point can be in shadow for longer than the limit. Such a point is in shadow at
/// one of the steps that are left when as many of the lowest suns as the limit has are taken away.
double reachOfLimitM(const Rule& rule, const SunSteps& sun, double heightM) {
    std::vector<float> altitudes;
    for (const SunStep& step : sun.steps) altitudes.push_back(step.altitudeDeg);
    std::ranges::sort(altitudes);
    const auto skipped = std::size_t(minLimitBeyond(rule) / sun.stepMinutes);
    if (skipped >= altitudes.size()) return 0;
    const double tangent = std::tan(Degrees{altitudes[skipped]}.radians().value);
    constexpr double farthestM = 2000;
    return std::min(farthestM, std::max(0.0, heightM - rule.receivers.planeM) / tangent);
}

Result<RulePlaces> placesToMeasure(const Rule& rule, const std::vector<Place>& places, const City& scenario,
                                   const SunSteps& sun) {
    if (!rule.receivers.hasLines()) return RulePlaces{places, std::vector(places.size(), LineBelt::none)};
    const auto& [inner, outer] = std::pair{rule.receivers.innerLineM, rule.receivers.outerLineM};
    const double reach = std::max(outer + 10, reachOfLimitM(rule, sun, highestM(scenario)));
    RulePlaces measured;
    for (const Place& place : places)
        for (const LineBelt belt : {LineBelt::betweenLines, LineBelt::beyondLines}) {
            const bool between = belt == LineBelt::betweenLines;
            auto polygons = cutBelt(place.polygons, between ? inner : outer, between ? outer : reach);
            if (!polygons) return tl::make_unexpected(polygons.error());
            const std::string name = between ? fmt::format("{}, {:g} to {:g} m", place.name, inner, outer)
                                             : fmt::format("{}, beyond {:g} m", place.name, outer);
            measured.places.push_back({name, place.kind, *std::move(polygons), place.source});
            measured.belts.push_back(belt);
        }
    return measured;
}

Result<RuleScene> makeRuleScene(const Rule& rule, City before, City after, const std::vector<Place>& places,
                                double cellM, const std::stop_token& stop) {
    const bool plane = rule.receivers.surface == RuleSurface::plane;
    auto beforeAbove = plane ? cutAbovePlane(before, rule.receivers.planeM) : std::nullopt;
    auto afterAbove = plane ? cutAbovePlane(after, rule.receivers.planeM) : std::nullopt;
    const bool isLowered = beforeAbove && afterAbove;
    if (isLowered) before = *std::move(beforeAbove), after = *std::move(afterAbove);
    const std::array<const City*, 2> cities{&before, &after};
    auto receivers = placeReceiversOnPlaces(cities, places, {.cellM = cellM}, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    RuleScene scene{std::move(before), std::move(after), *std::move(receivers)};
    if (rule.occluders.casters == RuleCasters::proposal && scene.after.terrain)
        scene.bare = City{scene.after.frame, {}, scene.after.terrain};
    if (!plane || isLowered) return scene;
    raiseToPlane(scene.receivers.receivers, rule.receivers.planeM);
    const std::vector<float>& raised = scene.receivers.receivers.groundM;
    if (!raised.empty()) scene.planeZ = raised.front();
    return scene;
}

}  // namespace

Result<void> shadeScene(const Engine& engine, const PreparedReview& prepared, const TakePlaces& take,
                        Progress& progress, std::stop_token stop) {
    const RuleScene& scene = prepared.scene;
    std::vector<const City*> cities{&scene.before};
    if (scene.bare) cities.push_back(&*scene.bare);
    cities.push_back(&scene.after);
    const auto join = [](std::span<StepMasks> masks) {
        if (masks.size() < 3) return;
        removeShadow(masks.front(), masks[1]);
        removeShadow(masks.back(), masks[1]);
    };
    return shadePlaces(engine, cities, join, scene.receivers, prepared.days.sun, take, progress,
                       std::move(stop));
}

Result<void> shadeWithout(const Engine& engine, const PreparedReview& prepared, const City& without,
                          const TakePlaces& take, Progress& progress, std::stop_token stop) {
    const RuleScene& scene = prepared.scene;
    const std::vector<const City*> cities{&without, &scene.before, &scene.after};
    const auto join = [](std::span<StepMasks> masks) { addShadow(masks.front(), masks[1]); };
    return shadePlaces(engine, cities, join, scene.receivers, prepared.days.sun, take, progress,
                       std::move(stop));
}

City keepOwnBuildings(const City& city, const City& other) {
    std::set<const Building*> shared;
    std::multimap<std::string, const Building*> byId;
    for (const auto& building : other.buildings) {
        shared.insert(building.get());
        byId.emplace(building->sourceId, building.get());
    }
    const auto isIn = [&](const std::shared_ptr<const Building>& building) {
        if (shared.contains(building.get())) return true;
        const auto [from, to] = byId.equal_range(building->sourceId);
        return std::any_of(from, to, [&](const auto& same) { return *same.second == *building; });
    };
    City own = city;
    std::erase_if(own.buildings, isIn);
    return own;
}

CastingCities chooseCasters(const Rule& rule, const City& baseline, const City& scenario) {
    if (rule.occluders.casters == RuleCasters::everything) return {baseline, scenario};
    CastingCities casting{keepOwnBuildings(baseline, scenario), keepOwnBuildings(scenario, baseline)};
    if (rule.baseline.kind != BaselineKind::referenceBody) casting.before.buildings.clear();
    return casting;
}

Result<PreparedReview> prepareReview(const Rule& rule, const City& baseline, const City& scenario,
                                     const std::vector<Place>& places, const ReviewSettings& settings,
                                     const std::stop_token& stop) {
    if (rule.receivers.surface == RuleSurface::windows)
        return unsupported("The rule is about windows, not about places", rule.key,
                           fmt::format("Review windows with noonmark-cli review run {} FILE or {} NAMES",
                                       flagOf(glazingFields().rows(), "windows"),
                                       flagOf(facadesOfFields().rows(), "facades_of")));
    CastingCities casting = chooseCasters(rule, baseline, scenario);
    auto days = computeRuleSun(rule, {observerOfPlaces(baseline), settings.zone, settings.year}, stop);
    if (!days) return tl::make_unexpected(days.error());
    auto measured = placesToMeasure(rule, places, casting.after, days->sun);
    if (!measured) return tl::make_unexpected(measured.error());
    auto scene = makeRuleScene(rule, std::move(casting.before), std::move(casting.after), measured->places,
                               settings.cellM, stop);
    if (!scene) return tl::make_unexpected(scene.error());
    return PreparedReview{*std::move(days), *std::move(measured), *std::move(scene)};
}

}  // namespace noonmark
