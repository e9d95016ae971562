#pragma once

// Projected shadows, the exact engine for flat ground, and its cache. casters/ turns buildings into convex
// casters and projects them at the steps of a period; filling/ fills their shadows, eight steps at a time,
// into bit rasters; counting/ turns rasters into gross and continuous shadow; masks/ states which receivers
// of places are in shadow at each step. This file has the engine, and its minutes by sets of steps.
// shadow_cache.h updates a day's result after an edit.

#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/engines/api/step_sets.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Minutes in shadow by sets of steps, for the cities and receivers that ProjectedShadows takes. Each set has
/// the same result as a run over its own steps, bit for bit. Buildings are processed once and each step is
/// filled once, so the cost is that of a run over the whole period plus some 3 ms per set for 800 x 800
/// cells. `sets.ofStep`: one entry per step. Does not break down by building.
Result<ShadowBreakdown> computeProjectedBreakdown(const City& city, const Receivers& receivers,
                                                  const SunSteps& sun, const StepSets& sets,
                                                  Progress& progress, const std::stop_token& stop);

/// Exact shadows on flat ground, computed building by building: at every step each building's shadow is a
/// polygon, filled into a bit raster of the region. No rays, no depth buffer, no bias; supports prisms,
/// raised parts and closed meshes. Terrain is refused. Receivers are at the positions of placeRayOrigin(), so
/// a cell should differ from the ray reference only if it lies within float rounding of a shadow's edge: in a
/// dense city some 10 of 300,000 cells differ, by a minute per day. Larger differences occur only if a cell
/// lies within 0.1 mm of a wall and the reference's rays, which are moved aside, begin inside the building:
/// with the sun along that wall they hit it on the way out (one such cell there, 18 min). Cost per step, on
/// one core: 20 ns for each polygon that meets the region, and 1 ns for each of its rows.
class ProjectedShadows final : public Engine {
public:
    [[nodiscard]] std::string_view name() const override { return "Projected shadows"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{
        .sets = true, .stepMasks = true, .cache = true, .independence = Independence::always};

protected:
    [[nodiscard]] Result<ShadowField> compute(const City& city, const Receivers& receivers,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const override;
    [[nodiscard]] Result<ShadowBreakdown> computeBreakdown(const City& city, const Receivers& receivers,
                                                           const SunSteps& sun, const StepSets& sets,
                                                           bool byBuilding, Progress& progress,
                                                           std::stop_token stop) const override;
    [[nodiscard]] Result<void> computeStepMasks(std::span<const City* const> cities,
                                                const Receivers& receivers, const SunSteps& sun,
                                                const TakeDay& take, Progress& progress,
                                                std::stop_token stop) const override;
};

/// The rasters themselves, step by step (core/engines/projected/filling/bit_raster.h), for comparisons and
/// edits. Flat ground only.
Result<std::vector<std::uint64_t>> computeShadowRasters(const City& city, const Receivers& receivers,
                                                        const SunSteps& sun);

}  // namespace noonmark
