#include "core/accumulate/auto_engine.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/accumulate/engine_list.h"
#include "core/accumulate/horizon_sweep.h"
#include "core/accumulate/projected_shadows.h"
#include "core/accumulate/ray_reference.h"
#include "core/accumulate/reach.h"

namespace noonmark {

namespace {

constexpr double shortSeconds = 2;

std::size_t mostInReach(std::span<const City* const> cities, const Receivers& receivers,
                        const SunSteps& sun) {
    std::size_t most = 0;
    for (const City* city : cities) most = std::max(most, buildingsInReach(*city, receivers, sun).size());
    return most;
}

std::size_t mostTerrainCells(std::span<const City* const> cities) {
    std::size_t most = 0;
    for (const City* city : cities)
        if (city->terrain) most = std::max(most, city->terrain->grid.size());
    return most;
}

}  // namespace

ExpectedSeconds expectedSeconds(const Receivers& receivers, std::size_t buildingsInReach, const SunSteps& sun,
                                double binDeg, std::size_t terrainCells) {
    const auto cells = double(receivers.cells.size()), steps = double(sun.steps.size()),
               buildings = double(buildingsInReach);
    const double bins = std::min(steps, 360 / binDeg);
    return {.ray = cells * steps * 10e-9,
            .projected = steps * (buildings * 0.2e-6 + receivers.grid.rows * 0.5e-6),
            .horizon = bins * (cells * (receivers.flat() ? 5e-9 : 40e-9) + buildings * 0.05e-6 +
                               double(terrainCells) * 10e-9) +
                       cells * steps * 3e-12};
}

Result<ShadowField> EngineChoice::accumulate(const City& city, const Receivers& receivers,
                                             const SunSteps& sun, Progress& progress,
                                             std::stop_token stop) const {
    return engine->accumulate(city, receivers, sun, progress, std::move(stop)).map([&](ShadowField field) {
        field.engine = fmt::format("{} (chosen: {})", field.engine, why);
        field.engineKey = key;
        return field;
    });
}

EngineChoice raysSince(const EngineChoice& refused, const Error& error) {
    return {referenceEngine, std::make_unique<RayReference>(),
            fmt::format("rays, since {} refused: {}", refused.why, error.what)};
}

// The exact engine where it takes no longer than the sweep, or not long; else the sweep.
EngineChoice AutoEngine::choose(std::span<const City* const> cities, const Receivers& receivers,
                                const SunSteps& sun) const {
    const std::size_t terrainCells = mostTerrainCells(cities);
    const bool even = terrainCells == 0 && receivers.flat();
    const ExpectedSeconds seconds =
        expectedSeconds(receivers, mostInReach(cities, receivers, sun), sun, binDeg_, terrainCells);
    const double exact = even ? seconds.projected : seconds.ray;
    const std::string expected = fmt::format("expected {:.2g} s by {}, {:.2g} s by the sweep", exact,
                                             even ? "projected shadows" : "rays", seconds.horizon);
    if (exact > std::max(shortSeconds, seconds.horizon))
        return {"horizon", std::make_unique<HorizonSweep>(HorizonSweepSettings{binDeg_}),
                fmt::format("the horizon sweep, since the period is long ({})", expected)};
    if (even)
        return {"projected", std::make_unique<ProjectedShadows>(),
                fmt::format("projected shadows, exact and quick enough here ({})", expected)};
    return {referenceEngine, std::make_unique<RayReference>(),
            fmt::format("rays, since {} and they are quick enough here ({})",
                        terrainCells > 0 ? "there is terrain" : "receivers lie on roofs", expected)};
}

Result<ShadowField> AutoEngine::accumulate(const City& city, const Receivers& receivers, const SunSteps& sun,
                                           Progress& progress, std::stop_token stop) const {
    const City* const cities[]{&city};
    const EngineChoice choice = choose(cities, receivers, sun);
    Result<ShadowField> field = choice.accumulate(city, receivers, sun, progress, stop);
    if (field || isCancelled(field.error()) || choice.key == referenceEngine) return field;
    return raysSince(choice, field.error()).accumulate(city, receivers, sun, progress, std::move(stop));
}

}  // namespace noonmark
