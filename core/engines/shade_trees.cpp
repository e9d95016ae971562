#include "core/engines/shade_trees.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/engines/auto_engine.h"
#include "core/engines/horizon/trees/crown_sweep.h"
#include "core/engines/ray/tree_rays.h"

namespace noonmark {

namespace {

std::shared_ptr<const TreeShade> selectColumns(std::shared_ptr<const TreeShade> shade, TreeColumns columns) {
    if (!shade || columns == TreeColumns::all) return shade;
    if (columns == TreeColumns::without) return nullptr;
    TreeShade some = *shade;
    if (columns != TreeColumns::evergreen) some.evergreen.reset();
    if (columns != TreeColumns::seasonal) some.seasonal.reset();
    return std::make_shared<const TreeShade>(std::move(some));
}

// Exact rays are taken for the shade of one field where they take no longer, as by AutoEngine.
constexpr double shortSeconds = 2;

// Fitted to the parks, streets and small places of Midtown, Chicago and Monaco over a year, on two cores. A
// sweep of crowns takes about as long as one of buildings for months on the cells of places.
constexpr double secondsOfRay = 60e-9, secondsOfCrown = 8e-9, sweepOverModel = 4;

TreeSeconds estimateSeconds(const City& city, const CrownScene& crowns, const Receivers& receivers,
                            const SunSteps& sun, ShadowCounts counts) {
    const City* const cities[]{&city};
    const double rays = double(receivers.cells.size()) * double(sun.steps.size());
    const double ofRay = secondsOfRay + secondsOfCrown * countCrownsAtRays(crowns, receivers, sun);
    EngineLoad load = measureLoadOfPlaces(cities, receivers, sun);
    load.runs = counts == ShadowCounts::grossAndRuns;
    return {.rays = rays * ofRay,
            .sweep = estimateSeconds(load).horizon * sweepOverModel * double(crowns.phases.count())};
}

void addMinutes(const std::vector<float>& taken, const Receivers& receivers, ShadowField& column) {
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        float& gross = column.grossMin[receivers.cells[i]];
        gross = std::min(gross + taken[i] / float(column.days), float(column.sunlitMinutesPerDay));
    }
}

void addRunsOfColumn(const std::vector<float>& with, const std::vector<float>& without,
                     const Receivers& receivers, ShadowField& column) {
    for (std::size_t i = 0; i < with.size(); ++i) {
        float& longest = column.continuousMin[receivers.cells[i]];
        if (with[i] > without[i]) longest = std::max(longest, with[i]);
    }
}

ShadowCounts countsOf(const ShadowField& field, const Receivers& receivers) {
    const bool hasRuns = !receivers.cells.empty() && !field.continuousMin.empty() &&
                         !std::isnan(field.continuousMin[receivers.cells.front()]);
    return hasRuns ? ShadowCounts::grossAndRuns : ShadowCounts::gross;
}

// What a sweep finds that trees take, on top of the field.
Result<std::shared_ptr<const TreeShade>> sweepTrees(const City& city, const Receivers& receivers,
                                                    const SunSteps& sun, const ShadowField& field,
                                                    Progress& progress, const std::stop_token& stop) {
    const CrownScene crowns = findCrowns(city, receivers, sun);
    if (crowns.empty()) return nullptr;
    const auto taken = sweepCrowns(city, crowns, receivers, sun, makeOneSet(sun), progress, stop,
                                   countsOf(field, receivers));
    if (!taken) return tl::make_unexpected(taken.error());
    TreeShade shade = makeTreeShade(field, taken->treesUsed);
    addMinutes(taken->evergreen.front(), receivers, *shade.evergreen);
    addMinutes(taken->seasonal.front(), receivers, *shade.seasonal);
    addRuns(taken->runs, receivers, shade);
    shade.how = taken->how;
    return std::make_shared<const TreeShade>(std::move(shade));
}

}  // namespace

void addRuns(const SweptRuns& runs, const Receivers& receivers, TreeShade& shade) {
    addRunsOfColumn(runs.evergreen, runs.without, receivers, *shade.evergreen);
    addRunsOfColumn(runs.seasonal, runs.without, receivers, *shade.seasonal);
}

City withTreesFor(City city, TreeColumns columns) {
    if (columns == TreeColumns::without) city.trees.reset();
    if (!city.trees || city.trees->weighed) return city;
    Trees weighed = *city.trees;
    weighed.weighed = true;
    city.trees = std::make_shared<const Trees>(std::move(weighed));
    return city;
}

const ShadowField& fieldOfColumn(const ShadowField& field, TreeColumns column) {
    for (const ShadeColumn& shade : listShadeColumns(field))
        if (shade.column == column) return *shade.field;
    return field;
}

TreeSeconds estimateTreeSeconds(const City& city, const Receivers& receivers, const SunSteps& sun,
                                ShadowCounts counts) {
    if (!city.trees || city.trees->trees.empty()) return {};
    const CrownScene crowns = findCrowns(withTreesFor(city, TreeColumns::all), receivers, sun);
    return crowns.empty() ? TreeSeconds{} : estimateSeconds(city, crowns, receivers, sun, counts);
}

Result<std::shared_ptr<const TreeShade>> shadeTrees(const City& city, const Receivers& receivers,
                                                    const SunSteps& sun, const ShadowField& field,
                                                    TreeColumns columns, Progress& progress,
                                                    const std::stop_token& stop) {
    if (!city.trees || columns == TreeColumns::without) return nullptr;
    if (field.trees) return selectColumns(field.trees, columns);
    const TreeSeconds seconds = estimateTreeSeconds(city, receivers, sun, countsOf(field, receivers));
    if (seconds.rays > std::max(shortSeconds, seconds.sweep)) {
        auto shade = sweepTrees(city, receivers, sun, field, progress, stop);
        if (shade) return selectColumns(*std::move(shade), columns);
        if (isCancelled(shade.error())) return tl::make_unexpected(shade.error());
    }
    return traceTrees(city, receivers, sun, field, progress, stop).map([&](auto shade) {
        return selectColumns(std::move(shade), columns);
    });
}

namespace {

// A sum of rounded altitudes may exceed what is left of the time by a trifle.
ShadowBreakdown addTakenMinutes(const ShadowBreakdown& without,
                                const std::vector<std::vector<float>>& taken) {
    ShadowBreakdown with = without;
    for (std::size_t set = 0; set < taken.size(); ++set)
        for (std::size_t i = 0; i < taken[set].size(); ++i)
            with.minutes[set][i] =
                std::min(with.minutes[set][i] + taken[set][i], float(without.sunlitMinutes[set]));
    return with;
}

Result<std::optional<TakenBySet>> takeSets(const City& city, const Receivers& receivers, const SunSteps& sun,
                                           const StepSets& sets, Progress& progress,
                                           const std::stop_token& stop) {
    const CrownScene crowns = findCrowns(city, receivers, sun);
    if (crowns.empty()) return std::nullopt;
    if (!areRaysQuicker(sun)) {
        auto swept = sweepCrowns(city, crowns, receivers, sun, sets, progress, stop);
        if (swept) return *std::move(swept);
        if (isCancelled(swept.error())) return tl::make_unexpected(swept.error());
    }
    return traceTreeSets(city, receivers, sun, sets, progress, stop);
}

}  // namespace

Result<std::optional<ShadedSets>> shadeTreeSets(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, const ShadowBreakdown& without,
                                                TreeColumns columns, Progress& progress,
                                                const std::stop_token& stop) {
    if (!city.trees || columns == TreeColumns::without) return std::nullopt;
    auto taken = takeSets(withTreesFor(city, columns), receivers, sun, without.sets, progress, stop);
    if (!taken) return tl::make_unexpected(taken.error());
    if (!*taken) return std::nullopt;
    ShadedSets shaded{.treesUsed = (*taken)->treesUsed, .how = (*taken)->how};
    if (columns != TreeColumns::seasonal) shaded.evergreen = addTakenMinutes(without, (*taken)->evergreen);
    if (columns != TreeColumns::evergreen) shaded.seasonal = addTakenMinutes(without, (*taken)->seasonal);
    return shaded;
}

}  // namespace noonmark
