#include "core/accumulate/auto_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "core/accumulate/horizon_sweep.h"
#include "core/accumulate/projected_shadows.h"
#include "core/accumulate/ray_reference.h"
#include "core/accumulate/reach.h"

namespace noonmark {

namespace {

constexpr double shortSeconds = 2;

struct Choice {
    const char* key;
    std::unique_ptr<Accumulator> engine;
    std::string why;
};

Choice chosen(const City& city, const Receivers& receivers, const SunSteps& sun, double binDeg) {
    if (city.terrain || !receivers.flat())
        return {"ray", std::make_unique<RayReference>(), "rays, since there is terrain"};
    const std::size_t buildings = buildingsInReach(city, receivers, sun).size();
    const ExpectedSeconds seconds = expectedSeconds(receivers, buildings, sun, binDeg);
    const std::string expected = fmt::format("expected {:.2g} s by projected shadows, {:.2g} s by the sweep",
                                             seconds.projected, seconds.horizon);
    if (seconds.projected <= std::max(shortSeconds, seconds.horizon))
        return {"projected", std::make_unique<ProjectedShadows>(),
                fmt::format("projected shadows, exact and quick enough here ({})", expected)};
    return {"horizon", std::make_unique<HorizonSweep>(HorizonSweepSettings{binDeg}),
            fmt::format("the horizon sweep, since the period is long ({})", expected)};
}

}  // namespace

ExpectedSeconds expectedSeconds(const Receivers& receivers, std::size_t buildingsInReach, const SunSteps& sun,
                                double binDeg) {
    const auto cells = double(receivers.cells.size()), steps = double(sun.steps.size()),
               buildings = double(buildingsInReach);
    const double bins = std::min(steps, 360 / binDeg);
    return {.ray = cells * steps * 10e-9,
            .projected = steps * (buildings * 0.2e-6 + receivers.grid.rows * 0.5e-6),
            .horizon = bins * (cells * 5e-9 + buildings * 0.05e-6) + cells * steps * 3e-12};
}

Result<ShadowField> AutoEngine::accumulate(const City& city, const Receivers& receivers, const SunSteps& sun,
                                           Progress& progress, std::stop_token stop) const {
    const Choice choice = chosen(city, receivers, sun, binDeg_);
    std::string why = choice.why, key = choice.key;
    Result<ShadowField> field = choice.engine->accumulate(city, receivers, sun, progress, stop);
    if (!field && !isCancelled(field.error())) {
        why = fmt::format("rays, since {} refused: {}", choice.why, field.error().what);
        key = "ray";
        field = RayReference().accumulate(city, receivers, sun, progress, std::move(stop));
    }
    if (!field) return field;
    field->engine = fmt::format("{} (chosen: {})", field->engine, why);
    field->engineKey = key;
    return field;
}

}  // namespace noonmark
