#pragma once

#include <vector>

#include "core/accumulate/accumulator.h"

namespace noonmark {

/// Exact shadows on flat ground, in object order: at every step each building's shadow is a polygon, filled
/// into a bit raster of the region. No rays, no depth buffer, no bias; any prism, lifted part or closed mesh.
/// Terrain is refused. A cell differs from the ray reference only where its centre lies within rounding of a
/// shadow's edge. Cost: about (polygon rows that meet the region) x 5 ns a step and core.
class ProjectedShadows final : public Accumulator {
public:
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const override;
};

/// The rasters themselves, step after step (core/accumulate/projected/bit_raster.h), for comparisons and
/// edits. Flat ground only.
Result<std::vector<std::uint64_t>> projectedRasters(const City& city, const Receivers& receivers,
                                                    const SunSteps& sun);

}  // namespace noonmark
