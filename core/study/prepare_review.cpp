#include "core/study/prepare_review.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <utility>

#include "core/base/safe_text.h"
#include "core/base/units.h"
#include "core/base/wording.h"
#include "core/describe/fill_text.h"
#include "core/describe/text.h"
#include "core/engines/common/changed_buildings.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/ray/ray_reference.h"
#include "core/receivers/parcels/parcel_lines.h"
#include "core/receivers/place_names.h"
#include "core/receivers/roof_receivers.h"
#include "core/review/criteria/worst_spots.h"
#include "core/review/rule/rule_names.h"
#include "core/study/elements/element_fields.h"

namespace noonmark {

namespace {

/// Trees that are joined one by one to groups.
class TreeGroups {
public:
    explicit TreeGroups(std::size_t trees) : parent_(trees) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t tree) {
        while (parent_[tree] != tree) tree = parent_[tree] = parent_[parent_[tree]];
        return tree;
    }
    void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<std::size_t> parent_;
};

bool isDenseEvergreen(const Tree& tree) {
    return tree.evergreen && tree.leafOnTransmissivity <= maxBeltTransmissivity;
}

bool areInOneBelt(const Tree& a, const Tree& b) {
    const double radii = double(a.crownDiameterM + b.crownDiameterM) / 2;
    return glm::distance(a.place, b.place) <= radii + maxBeltGapM;
}

/// Where trees stand. A tree that the scenario grows is an existing one, one that it moves is not.
std::set<std::pair<double, double>> listPlaces(const City& city) {
    std::set<std::pair<double, double>> places;
    if (!city.trees) return places;
    for (const Tree& tree : city.trees->trees) places.emplace(tree.place.x, tree.place.y);
    return places;
}

std::vector<std::uint8_t> listCounted(RuleTrees counted, const City& city, const City& existing) {
    const std::vector<Tree>& trees = city.trees->trees;
    if (counted == RuleTrees::evergreenBelts) return findEvergreenBelts(trees);
    std::vector<std::uint8_t> all(trees.size(), counted == RuleTrees::without ? 0 : 1);
    const bool leavesSomeOut =
        counted == RuleTrees::evergreens || counted == RuleTrees::existingAndEvergreens;
    if (!leavesSomeOut) return all;
    const auto places =
        counted == RuleTrees::evergreens ? std::set<std::pair<double, double>>() : listPlaces(existing);
    for (std::size_t i = 0; i < trees.size(); ++i)
        all[i] = trees[i].evergreen || places.contains({trees[i].place.x, trees[i].place.y}) ? 1 : 0;
    return all;
}

}  // namespace

City keepCountedTrees(RuleTrees counted, City city, const City& existing) {
    if (!city.trees) return city;
    const std::vector<std::uint8_t> isCounted = listCounted(counted, city, existing);
    Trees trees{.leafDays = city.trees->leafDays, .weighed = true};
    if (counted == RuleTrees::asEvergreens) trees.leafDays = {};
    for (std::size_t i = 0; i < isCounted.size(); ++i)
        if (isCounted[i] != 0) trees.trees.push_back(city.trees->trees[i]);
    if (counted == RuleTrees::asEvergreens)
        for (Tree& tree : trees.trees) tree.leafOnDay = tree.leafOffDay = std::nullopt;
    city.trees = trees.trees.empty() ? nullptr : std::make_shared<const Trees>(std::move(trees));
    return city;
}

bool haveSameTrees(const City& one, const City& other) {
    return one.trees == other.trees || (one.trees && other.trees && *one.trees == *other.trees);
}

std::string describeCountedTrees(RuleTrees counted) {
    return fillText(NM_TEXT("Trees: %1"), {localText(describe(counted))});
}

std::string describeCountedTrees(RuleTrees counted, const City& city, const City& existing) {
    const std::size_t all = city.trees ? city.trees->trees.size() : 0;
    const std::string what = describeCountedTrees(counted);
    if (all == 0) return what + localText(NM_TEXT("; the city has no trees"));
    if (!isEnglishInUse() && counted == RuleTrees::without)
        return what + fillText(NM_TEXT("; trees in the city: %1"), {localNumbers(formatNumber(double(all)))});
    if (counted == RuleTrees::without) return fmt::format("{}; the city has {}", what, countOf(all, "tree"));
    const City kept = keepCountedTrees(counted, city, existing);
    if (!isEnglishInUse())
        return what + fillText(NM_TEXT("; trees that count: %1 of %2"),
                               {localNumbers(formatNumber(double(kept.trees ? kept.trees->trees.size() : 0))),
                                localNumbers(formatNumber(double(all)))});
    return fmt::format("{}; {} of the city's {} count", what, kept.trees ? kept.trees->trees.size() : 0,
                       countOf(all, "tree"));
}

std::vector<std::uint8_t> findEvergreenBelts(const std::vector<Tree>& trees) {
    std::vector<std::size_t> west;  // dense evergreens, from west to east
    float widestM = 0;
    for (std::size_t i = 0; i < trees.size(); ++i)
        if (isDenseEvergreen(trees[i]))
            west.push_back(i), widestM = std::max(widestM, trees[i].crownDiameterM);
    std::ranges::sort(west, {}, [&](std::size_t i) { return trees[i].place.x; });
    TreeGroups groups(trees.size());
    for (std::size_t a = 0; a < west.size(); ++a)
        for (std::size_t b = a + 1; b < west.size(); ++b) {
            const Tree &one = trees[west[a]], &other = trees[west[b]];
            if (other.place.x - one.place.x > double(widestM) + maxBeltGapM) break;
            if (areInOneBelt(one, other)) groups.join(west[a], west[b]);
        }
    std::vector<std::size_t> sizes(trees.size());
    for (const std::size_t tree : west) ++sizes[groups.find(tree)];
    std::vector<std::uint8_t> isInBelt(trees.size());
    for (const std::size_t tree : west) isInBelt[tree] = sizes[groups.find(tree)] >= minBeltTrees ? 1 : 0;
    return isInBelt;
}

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

void addCrowns(const PreparedReview& prepared, const CrownMasks& crowns, const SunDay& day,
               StepMasks& masks) {
    const std::span<const SunStep> steps(prepared.days.sun.steps);
    crowns.addTo(masks, day.date, steps.subspan(day.first, day.count), prepared.scene.origins);
}

void findCountedCrowns(RuleScene& scene, const SunSteps& sun) {
    const Receivers& receivers = scene.receivers.receivers;
    if ((!scene.before.trees && !scene.after.trees) || receivers.cells.empty()) return;
    Box2 box;
    for (const std::uint32_t cell : receivers.cells) {
        scene.origins.push_back(placeRayOrigin(receivers.position(cell)));
        box.add(glm::vec2(scene.origins.back()));
    }
    const auto lowestM = float(lowestGroundM(receivers));
    scene.crownsBefore = CrownMasks(scene.before, box, lowestM, sun);
    scene.crownsAfter = CrownMasks(scene.after, box, lowestM, sun);
}

}  // namespace

Result<void> shadeScene(const Engine& engine, const PreparedReview& prepared, const TakePlaces& take,
                        Progress& progress, std::stop_token stop) {
    const RuleScene& scene = prepared.scene;
    std::vector<const City*> cities{&scene.before};
    if (scene.bare) cities.push_back(&*scene.bare);
    cities.push_back(&scene.after);
    const auto join = [&](const SunDay& day, std::span<StepMasks> masks) {
        addCrowns(prepared, scene.crownsBefore, day, masks.front());
        addCrowns(prepared, scene.crownsAfter, day, masks.back());
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
    const auto join = [&](const SunDay& day, std::span<StepMasks> masks) {
        addCrowns(prepared, scene.crownsAfter, day, masks.front());
        addCrowns(prepared, scene.crownsBefore, day, masks[1]);
        addCrowns(prepared, scene.crownsAfter, day, masks.back());
        addShadow(masks.front(), masks[1]);
    };
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
    const City before = keepCountedTrees(rule.occluders.trees, baseline, baseline);
    const City after = keepCountedTrees(rule.occluders.trees, scenario, baseline);
    if (rule.occluders.casters == RuleCasters::everything) return {before, after};
    CastingCities casting{keepOwnBuildings(before, after), keepOwnBuildings(after, before)};
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
    findCountedCrowns(*scene, days->sun);
    return PreparedReview{*std::move(days), *std::move(measured), *std::move(scene)};
}

namespace {

/// Whether what a scenario changes can shade a place at some step.
class ChangeReach {
public:
    explicit ChangeReach(const PreparedReview& prepared)
        : reach_(prepared.days.sun),
          treesDiffer_(!haveSameTrees(prepared.scene.before, prepared.scene.after)) {
        const RuleScene& scene = prepared.scene;
        const Receivers& receivers = scene.receivers.receivers;
        lowestM_ = scene.planeZ ? double(*scene.planeZ) : lowestGroundM(receivers);
        changed_ = findChangedBuildings(scene.before.buildings, scene.after.buildings);
    }

    [[nodiscard]] bool touches(const Place& place) const {
        if (treesDiffer_) return true;
        const Box2 box = bounds(place);
        const auto shades = [&](const std::shared_ptr<const Building>& building) {
            return reach_.touches(bounds(*building), double(topM(*building)) - lowestM_, box);
        };
        return std::ranges::any_of(changed_.added, shades) || std::ranges::any_of(changed_.removed, shades);
    }

private:
    ShadowReach reach_;
    ChangedBuildings changed_;
    double lowestM_ = 0;
    bool treesDiffer_;
};

}  // namespace

std::size_t expectSpotPoints(const Rule& rule, const PreparedReview& prepared) {
    const PlaceReceivers& receivers = prepared.scene.receivers;
    if (receivers.receivers.cells.empty()) return 0;
    const std::vector<SpotSearch> searches = listSpotSearches(rule);
    const auto ofNew =
        std::size_t(std::ranges::count(searches, Quantity::incremental, &SpotSearch::quantity));
    const ChangeReach reach(prepared);
    std::size_t points = 0;
    for (std::size_t i = 0; i < prepared.measured.places.size(); ++i) {
        const bool isReached = reach.touches(prepared.measured.places[i]);
        points += expectPoints(receivers.cellCount(i), searches.size() - (isReached ? 0 : ofNew));
    }
    return points;
}

}  // namespace noonmark
