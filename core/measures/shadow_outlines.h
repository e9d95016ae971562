#pragma once

#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Shadows on the open ground at one moment, as polygons in local metres. Ground that a building covers is
/// left out; ground below an overhang is not.
struct ShadowOutlines {
    std::vector<Footprint> baseline;     ///< shadow in the baseline
    std::vector<Footprint> incremental;  ///< shadow in the scenario where the baseline is lit
    std::vector<Footprint> gained;       ///< lit in the scenario, in shadow in the baseline
    /// 0: the exact union of the projected buildings. Else the outlines follow the edges of cells of this
    /// size, because the ground is not level.
    double cellM = 0;
};

struct OutlineSettings {
    Box2 area;         ///< outlines are cut at its edges, local metres
    double cellM = 1;  ///< where the ground is not level, 0.25 to 10
};

/// The shadows of a baseline and of a scenario (null: the baseline alone) at a step of the sun. Error: an
/// empty area, the polygons cannot be joined, errors of the ray reference, or cancelled().
Result<ShadowOutlines> outlineShadows(const City& baseline, const City* scenario, const SunStep& step,
                                      const OutlineSettings& settings, Progress& progress,
                                      const std::stop_token& stop);

}  // namespace noonmark
