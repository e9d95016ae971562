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

/// What one tree takes of the sun that buildings leave, over all receivers and the whole period.
struct TreeTaken {
    std::uint32_t tree = 0;  ///< index in City::trees
    /// On each ray by its share of the optical depth; all trees add up to what crowns take.
    double attributedMinM2 = 0;
    double soleMinM2 = 0;  ///< what would be lit if only this tree were gone
};

/// The same of all trees that take some, ascending by tree.
struct TakenByTree {
    std::vector<TreeTaken> evergreen, seasonal;
    std::size_t cells = 0;  ///< receivers that were measured, evenly spread, if not all
    [[nodiscard]] const std::vector<TreeTaken>& of(TreeColumns column) const {
        return column == TreeColumns::evergreen ? evergreen : seasonal;
    }
};

/// What single trees take: a ray to each half degree of the sun's paths, with the exact length of its path
/// through each crown. From all receivers up to 10^8 rays, else from so many of them, evenly spread, that
/// they are fewer. The same in whatever order threads work.
Result<TakenByTree> traceTakenByTree(const City& city, const Receivers& receivers, const SunSteps& sun,
                                     Progress& progress, const std::stop_token& stop);

/// As traceTakenByTree(), of one place: minutes in place of min x m2, over the steps at which `shaded` is 0.
TakenByTree takeFromPoint(const CrownScene& crowns, glm::vec3 origin, const SunSteps& sun,
                          const std::vector<std::uint8_t>& shaded);

}  // namespace noonmark
