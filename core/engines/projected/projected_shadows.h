
protected:
[[nodiscard]] Result<ShadowField> compute(const City& city, const Receivers& receivers, const SunSteps& sun,
                                          Progress& progress, std::stop_token stop) const override;
[[nodiscard]] Result<ShadowBreakdown> computeBreakdown(const City& city, const Receivers& receivers,
                                                       const SunSteps& sun, const StepSets& sets,
                                                       bool byBuilding, Progress& progress,
                                                       std::stop_token stop) const override;
#pragma once

#include <vector>

#include "core/engines/api/engine.h"

namespace noonmark {

/// Exact shadows on flat ground, in object order: at every step each building's shadow is a polygon, filled
/// into a bit raster of the region. No rays, no depth buffer, no bias; any prism, lifted part or closed mesh.
/// Terrain is refused. Receivers stand where placeRayOrigin() puts them, so a cell should differ from the ray
/// reference only where it lies within float rounding of a shadow's edge: in a dense city some 10 of 300,000
/// cells differ, by a minute a day. More only where a cell stands within 0.1 mm of a wall and the reference's
/// rays, moved aside, begin inside: with the sun along that wall they meet it on their way out (one such cell
/// there, 18 min). Cost: (polygons that meet the region) x 20 ns a step and core, and 1 ns for each of their
/// rows.
class ProjectedShadows final : public Engine {
public:
    [[nodiscard]] std::string_view name() const override { return "Projected shadows"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{
        .sets = true, .cache = true, .independence = Independence::always};
};

/// The rasters themselves, step after step (core/engines/projected/filling/bit_raster.h), for comparisons and
/// edits. Flat ground only.
Result<std::vector<std::uint64_t>> computeShadowRasters(const City& city, const Receivers& receivers,
                                                        const SunSteps& sun);

}  // namespace noonmark
