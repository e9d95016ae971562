#include "core/engines/auto_engine.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/engines/api/engine_registry.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_reference.h"

namespace noonmark {

namespace {

constexpr double shortSeconds = 2;

std::size_t overhangTrianglesOf(const Building& building) {
    std::size_t triangles = 0;
    for (const Part& part : building.parts)
        if (part.isOverhanging) triangles += meshOf(part).triangles.size();
    return triangles;
}

void addMaximum(EngineLoad& load, const City& city, const Receivers& receivers, const SunSteps& sun) {
    const std::vector<std::uint32_t> inReach = findBuildingsInReach(city, receivers, sun);
    std::size_t triangles = 0;
    for (const std::uint32_t index : inReach) triangles += overhangTrianglesOf(*city.buildings[index]);
    load.buildings = std::max(load.buildings, inReach.size());
    load.overhangTriangles = std::max(load.overhangTriangles, triangles);
    if (!city.terrain) return;
    load.terrainCells = std::max(load.terrainCells, city.terrain->grid.size());
    load.level = false;
}

}  // namespace

EngineLoad measureEngineLoad(std::span<const City* const> cities, const Receivers& receivers,
                             const SunSteps& sun, const HorizonSweepSettings& sweep) {
    EngineLoad load{.receivers = receivers.cells.size(),
                    .rows = std::size_t(receivers.grid.rows),
                    .cellAreaM2 = receivers.grid.cellAreaM2(),
                    .steps = sun.steps.size(),
                    .bins = binCount(sun, sweep),
                    .level = receivers.flat(),
                    .runs = sweep.counts == ShadowCounts::grossAndRuns};
    for (const City* city : cities) addMaximum(load, *city, receivers, sun);
    return load;
}

// Overhangs take time where receivers are, not on all of their grid.
EngineLoad measureLoadOfPlaces(std::span<const City* const> cities, const Receivers& receivers,
                               const SunSteps& sun) {
    EngineLoad load = measureEngineLoad(cities, receivers, sun, HorizonSweepSettings());
    load.runs = false;
    const double cells = std::max<double>(1, double(receivers.cells.size()));
    load.cellAreaM2 =
        std::max(load.cellAreaM2, receivers.grid.cellAreaM2() * double(receivers.grid.size()) / cells);
    return load;
}

// Fitted to processor times, on two cores, of a day, a week, a month and a year on 300 and 800 m of the grid
// sample and of Midtown, with 708 to 3,604 overhang triangles. The fit for the sweep is within 50 %, but for
// the longest runs below overhangs only within a factor of two. The figures for rays, terrain and receivers
// at varying heights are times of single runs.
EstimatedSeconds estimateSeconds(const EngineLoad& load) {
    const auto receivers = double(load.receivers), steps = double(load.steps), bins = double(load.bins),
               buildings = double(load.buildings);
    const double sweepOfAReceiver = load.runs ? 3.6e-9 : 2.9e-9;
    const double sweepOfABin = receivers * (load.level ? sweepOfAReceiver : 40e-9) + buildings * 10e-9 +
                               double(load.terrainCells) * 10e-9 +
                               double(load.overhangTriangles) * 0.3e-6 / load.cellAreaM2;
    return {.ray = receivers * steps * 30e-9,
            .projected = steps * (buildings * 0.08e-6 + double(load.rows) * 0.12e-6),
            .horizon = bins * sweepOfABin + (load.runs ? receivers * steps * 5e-12 : 0)};
}

namespace {

bool isLevel(std::span<const City* const> cities, const Receivers& receivers) {
    return receivers.flat() &&
           std::ranges::none_of(cities, [](const City* city) { return city->terrain != nullptr; });
}

}  // namespace

EngineCapabilities AutoEngine::capabilities() const {
    return combineForChoice({RayReference::able, ProjectedShadows::able, HorizonSweep::able});
}

// The exact engine where it takes no longer than the sweep, or not long; else the sweep. The reason states no
// seconds: reports print it, and must print the same on another computer.
std::optional<EngineChoice> AutoEngine::choose(std::span<const City* const> cities,
                                               const Receivers& receivers, const SunSteps& sun) const {
    const EngineLoad load = measureEngineLoad(cities, receivers, sun, sweep_);
    const EstimatedSeconds seconds = estimateSeconds(load);
    const double exact = load.level ? seconds.projected : seconds.ray;
    if (exact > std::max(shortSeconds, seconds.horizon))
        return EngineChoice{"horizon", std::make_unique<HorizonSweep>(sweep_),
                            "the horizon sweep, since the period is long"};
    if (load.level)
        return EngineChoice{"projected", std::make_unique<ProjectedShadows>(),
                            "projected shadows, exact and quick enough here"};
    return EngineChoice{referenceEngine, std::make_unique<RayReference>(),
                        fmt::format("rays, since {} and they are quick enough here",
                                    load.terrainCells > 0 ? "there is terrain" : "receivers lie on roofs")};
}

std::optional<EngineChoice> AutoEngine::chooseInstead(const EngineChoice& failed, const Error& error) const {
    if (isCancelled(error) || failed.key == referenceEngine) return std::nullopt;
    return EngineChoice{referenceEngine, std::make_unique<RayReference>(),
                        fmt::format("rays, since {} refused: {}", failed.why, error.what)};
}

std::optional<EngineChoice> AutoEngine::chooseMoreExact(const EngineChoice& used,
                                                        const SampledDeviation& deviation,
                                                        std::span<const City* const> cities,
                                                        const Receivers& receivers,
                                                        const SunSteps& sun) const {
    if (used.key != "horizon" || sweep_.binDeg > 0) return std::nullopt;
    const double target = sweep_.errorTargetPercent,
                 chance = std::min(2 * deviation.standardErrorPct, target);
    if (!(deviation.meanPct > target + chance)) return std::nullopt;
    const std::string missed = fmt::format(
        "a sample of the horizon sweep is off by {:.3f} % of the period in the mean, more than "
        "the {:g} % aimed at",
        deviation.meanPct, target);
    const EstimatedSeconds seconds = estimateSeconds(measureEngineLoad(cities, receivers, sun, sweep_));
    if (isLevel(cities, receivers) && seconds.projected <= seconds.ray)
        return EngineChoice{"projected", std::make_unique<ProjectedShadows>(),
                            "projected shadows, since " + missed};
    return EngineChoice{referenceEngine, std::make_unique<RayReference>(), "rays, since " + missed};
}

Result<ShadowField> AutoEngine::compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                        Progress& progress, std::stop_token stop) const {
    const City* const cities[]{&city};
    const auto choice = choose(cities, receivers, sun);
    Result<ShadowField> field = choice->accumulate(city, receivers, sun, progress, stop);
    if (field) return field;
    const auto other = chooseInstead(*choice, field.error());
    return other ? other->accumulate(city, receivers, sun, progress, std::move(stop)) : field;
}

// Months by projected shadows where these make the field: both state the same then.
Result<ShadowBreakdown> AutoEngine::computeBreakdown(const City& city, const Receivers& receivers,
                                                     const SunSteps& sun, const StepSets& sets,
                                                     bool byBuilding, Progress& progress,
                                                     std::stop_token stop) const {
    const City* const cities[]{&city};
    const auto choice = choose(cities, receivers, sun);
    const bool able = !byBuilding && choice->engine->capabilities().sets;
    if (able) return choice->engine->breakDown(city, receivers, sun, sets, byBuilding, progress, stop);
    return HorizonSweep(sweep_).breakDown(city, receivers, sun, sets, byBuilding, progress, stop);
}

// An exact engine always: the sweep rounds azimuths, and what enters a place at which minute shows it.
std::string_view AutoEngine::stepMaskEngineName(std::span<const City* const> cities,
                                                const Receivers& receivers) const {
    return isLevel(cities, receivers) ? ProjectedShadows().name() : RayReference().name();
}

Result<void> AutoEngine::computeStepMasks(std::span<const City* const> cities, const Receivers& receivers,
                                          const SunSteps& sun, const TakeDay& take, Progress& progress,
                                          std::stop_token stop) const {
    if (isLevel(cities, receivers))
        return ProjectedShadows().shadeSteps(cities, receivers, sun, take, progress, std::move(stop));
    return RayReference().shadeSteps(cities, receivers, sun, take, progress, std::move(stop));
}

}  // namespace noonmark
