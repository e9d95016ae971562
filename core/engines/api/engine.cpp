#include "core/engines/api/engine.h"

#include <fmt/format.h>
#include <algorithm>

#include "core/base/memory_guard.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

// Marked outside of the class: lupdate takes its name for the context of what is marked in it.
constexpr const char* chooseSweep = NM_TEXT("Choose the horizon sweep");
constexpr const char* chooseMasks = NM_TEXT("Choose projected shadows, or rays on terrain and roofs");

}  // namespace

Result<ShadowField> Engine::accumulate(const City& city, const Receivers& receivers, const SunSteps& sun,
                                       Progress& progress, std::stop_token stop) const {
    return guardMemory({.where = std::string(name())}, [&]() -> Result<ShadowField> {
        if (const auto able = checkGround(city, receivers, capabilities(), name()); !able)
            return tl::make_unexpected(able.error());
        return compute(city, receivers, sun, progress, std::move(stop));
    });
}

Result<ShadowBreakdown> Engine::breakDown(const City& city, const Receivers& receivers, const SunSteps& sun,
                                          const StepSets& sets, bool byBuilding, Progress& progress,
                                          std::stop_token stop) const {
    return guardMemory({.where = std::string(name())}, [&]() -> Result<ShadowBreakdown> {
        if (const auto able = checkGround(city, receivers, capabilities(), name()); !able)
            return tl::make_unexpected(able.error());
        if (byBuilding ? !capabilities().attribution : !capabilities().sets)
            return unsupported(
                fmt::format("{} does not sum shadow by {}", name(), byBuilding ? "building" : "month"),
                "engine", chooseSweep);
        return computeBreakdown(city, receivers, sun, sets, byBuilding, progress, std::move(stop));
    });
}

Result<void> Engine::shadeSteps(std::span<const City* const> cities, const Receivers& receivers,
                                const SunSteps& sun, const TakeDay& take, Progress& progress,
                                std::stop_token stop) const {
    return guardMemory({.where = std::string(name())}, [&]() -> Result<void> {
        for (const City* city : cities)
            if (auto able = checkGround(*city, receivers, capabilities(), name()); !able) return able;
        if (!capabilities().stepMasks)
            return unsupported(
                fmt::format("{} does not state which receivers are in shadow at each step", name()), "engine",
                chooseMasks);
        return computeStepMasks(cities, receivers, sun, take, progress, std::move(stop));
    });
}

std::optional<EngineChoice> Engine::choose(std::span<const City* const> /*cities*/,
                                           const Receivers& /*receivers*/, const SunSteps& /*sun*/) const {
    return std::nullopt;
}

std::optional<EngineChoice> Engine::chooseInstead(const EngineChoice& /*failed*/,
                                                  const Error& /*error*/) const {
    return std::nullopt;
}

std::optional<EngineChoice> Engine::chooseMoreExact(const EngineChoice& /*used*/,
                                                    const SampledDeviation& /*deviation*/,
                                                    std::span<const City* const> /*cities*/,
                                                    const Receivers& /*receivers*/,
                                                    const SunSteps& /*sun*/) const {
    return std::nullopt;
}

Result<ShadowBreakdown> Engine::computeBreakdown(const City& /*city*/, const Receivers& /*receivers*/,
                                                 const SunSteps& /*sun*/, const StepSets& /*sets*/,
                                                 bool /*byBuilding*/, Progress& /*progress*/,
                                                 std::stop_token /*stop*/) const {
    return internalError(fmt::format("{} has no breakdown although it states one", name()));
}

Result<void> Engine::computeStepMasks(std::span<const City* const> /*cities*/, const Receivers& /*receivers*/,
                                      const SunSteps& /*sun*/, const TakeDay& /*take*/,
                                      Progress& /*progress*/, std::stop_token /*stop*/) const {
    return internalError(fmt::format("{} has no step masks although it states them", name()));
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

Result<void> checkGround(const City& city, const Receivers& receivers, const EngineCapabilities& capabilities,
                         std::string_view name) {
    const bool hasTerrain = city.terrain && !capabilities.terrain;
    if (!hasTerrain && (receivers.flat() || capabilities.roofs)) return {};
    return unsupported(fmt::format("{} works on flat ground only, and {}", name,
                                   hasTerrain ? "this city has terrain" : "the receivers lie on roofs"),
                       "engine", NM_TEXT("Choose the horizon sweep or the ray reference"));
}

Result<SurfaceShadow> makeBlankSurfaceShadow(const SurfacePoints& points, const SunSteps& sun) {
    if (points.positions.size() != points.normals.size())
        return failure(
            fmt::format("{} places have {} normals", points.positions.size(), points.normals.size()),
            "surface points", "Give each place the direction that its surface faces");
    SurfaceShadow shadow;
    shadow.grossMin.assign(points.size(), 0);
    shadow.continuousMin.assign(points.size(), 0);
    shadow.sunlitMinutesPerDay = sun.sunlitMinutes() / std::max(1.0, double(sun.dayCount()));
    shadow.cost.skipped["steps with the sun below the horizon"] = sun.belowHorizon;
    return shadow;
}

}  // namespace noonmark
