#pragma once

// The folder core/engines/trees has what engines that weigh crowns share: the crowns in reach of receivers
// and the steps in leaf (this file), and those around one receiver and the
// patches of the sun (crowns_around.h).
// core/engines/ray/tree_rays.h weighs them exactly.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/city/trees/tree.h"
#include "core/engines/api/tree_shade.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The crowns whose shadow can fall on a receiver at some step, and when they are in leaf.
struct CrownScene {
    std::vector<Crown> crowns;
    std::vector<std::uint32_t> trees;  ///< of each crown: index in City::trees
    std::vector<std::uint8_t> inLeaf;  ///< one per step: 1 where trees that lose their leaves have them
    [[nodiscard]] bool empty() const { return crowns.empty(); }
};

/// What crowns take of the sun that buildings leave, minutes by set of steps and then by receiver, and with
/// every tree in leaf all year or bare out of season.
struct TakenBySet {
    std::vector<std::vector<float>> evergreen, seasonal;
    std::size_t treesUsed = 0;  ///< trees whose shadow can reach a receiver
    std::string how;            ///< in words, for the report
    [[nodiscard]] const std::vector<std::vector<float>>& of(TreeColumns column) const {
        return column == TreeColumns::evergreen ? evergreen : seasonal;
    }
};

/// O(cells + trees + steps).
CrownScene findCrowns(const City& city, const Receivers& receivers, const SunSteps& sun);
/// Of points on any surface, likewise.
CrownScene findCrowns(const City& city, const SurfacePoints& points, const SunSteps& sun);

/// Both columns as the field without trees, without its cost and warnings.
TreeShade makeTreeShade(const ShadowField& without, std::size_t treesUsed);

}  // namespace noonmark
