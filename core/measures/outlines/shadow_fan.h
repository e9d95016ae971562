#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/measures/shadow_outlines.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The shadow that a proposal would cast if it stood alone, at several moments of a day.
struct ShadowFan {
    std::vector<std::vector<Footprint>> ofStep;  ///< one list a step
    std::vector<Footprint> all;                  ///< their union
    double cellM = 0;                            ///< as in ShadowOutlines
};

/// The fan of the buildings of `proposal`, which has only those, and the terrain: their shadow on open
/// ground, whatever other buildings shade or cover there. The ground that they cover themselves is left out.
/// On terrain, ground in the terrain's own shadow is left out too. Errors as of outlineShadows().
Result<ShadowFan> outlineShadowFan(const City& proposal, std::span<const SunStep> steps,
                                   const OutlineSettings& settings, Progress& progress,
                                   const std::stop_token& stop);

/// A box around all buildings of a city and their shadows, none of them taken longer than `longestM`. Empty
/// if there is no building.
Box2 boundShadows(const City& city, std::span<const SunStep> steps, double longestM);

}  // namespace noonmark
