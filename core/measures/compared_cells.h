#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/api/step_sets.h"
#include "core/engines/ray/ray_scene.h"
#include "core/measures/sampled_error.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Compares an engine's field at some receivers with rays through an existing scene over all steps. The scene
/// must hold at least every building in reach of these receivers. Publishes no partial results.
Result<std::vector<ComparedCell>> compareByRays(const RayScene& scene, const Receivers& receivers,
                                                const SunSteps& sun, const ShadowField& field,
                                                std::span<const std::uint32_t> cells, Progress& progress,
                                                const std::stop_token& stop);

/// Minutes of the period in shadow at some cells, by set of steps and then by cell: of an engine, and by the
/// ray reference over the same steps.
struct ComparedSets {
    std::vector<std::vector<double>> minutes;
    std::vector<std::vector<double>> reference;
};

/// Minutes of the period in shadow at these receivers, ascending, by set and then by cell, by rays. Costs
/// cells x steps rays and a ray scene of the buildings in reach.
Result<std::vector<std::vector<double>>> traceSets(const City& city, const Receivers& receivers,
                                                   const SunSteps& sun, const StepSets& sets,
                                                   const std::vector<std::uint32_t>& cells,
                                                   Progress& progress, const std::stop_token& stop);

/// An engine's sums by set at the cells of these receivers, by set and then by cell.
std::vector<std::vector<double>> minutesAt(const ShadowBreakdown& sums,
                                           const std::vector<std::uint32_t>& cells);

/// Holds an engine's sums by set against the ray reference at these receivers, ascending. Costs as of
/// traceSets().
Result<ComparedSets> compareSets(const City& city, const Receivers& receivers, const SunSteps& sun,
                                 const ShadowBreakdown& sums, const std::vector<std::uint32_t>& cells,
                                 Progress& progress, const std::stop_token& stop);

}  // namespace noonmark
