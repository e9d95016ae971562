#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/engines/api/step_sets.h"
#include "core/engines/api/tree_shade.h"
#include "core/engines/ray/ray_scene.h"
#include "core/engines/trees/crowns.h"

namespace noonmark {

/// The shade of crowns on top of a field's, with the exact length of each ray's path through each crown: at
/// a step that no building darkens, 1 - exp(-sum of path x optical depth of a metre). `scene`: the buildings
/// and the terrain in reach. Receivers that no crown can shade cost nothing; the others a ray for each step
/// and some 10 ns for each crown near its azimuth. Uses all cores; cancelled() within 0.2 s of a stop
/// request.
Result<TreeShade> traceCrowns(const RayScene& scene, const CrownScene& crowns, const Receivers& receivers,
                              const SunSteps& sun, const ShadowField& without, Progress& progress,
                              const std::stop_token& stop);

/// What crowns take of the sun that buildings leave by set of steps, likewise, with a scene of its own; none
/// where no tree reaches a receiver.
Result<std::optional<TakenBySet>> traceTreeSets(const City& city, const Receivers& receivers,
                                                const SunSteps& sun, const StepSets& sets, Progress& progress,
                                                const std::stop_token& stop);

/// The same with a scene of its own; null where no tree reaches a receiver.
Result<std::shared_ptr<const TreeShade>> traceTrees(const City& city, const Receivers& receivers,
                                                    const SunSteps& sun, const ShadowField& without,
                                                    Progress& progress, const std::stop_token& stop);

/// How many crowns a ray is held against in the mean: those near the azimuth of its step. Of some of the
/// receivers; O(crowns + steps) for each.
double countCrownsAtRays(const CrownScene& crowns, const Receivers& receivers, const SunSteps& sun);

}  // namespace noonmark
