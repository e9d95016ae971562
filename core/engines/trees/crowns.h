#pragma once

// The folder core/engines/trees has what engines that weigh crowns share: the crowns in reach of receivers
// and the steps in leaf (this file). core/engines/ray/tree_rays.h weighs them exactly.

#include <cstdint>
#include <vector>

#include "core/city/city.h"
#include "core/city/trees/tree.h"
#include "core/engines/api/tree_shade.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The crowns whose shadow can fall on a receiver at some step, and when they are in leaf.
struct CrownScene {
    std::vector<Crown> crowns;
    std::vector<std::uint8_t> inLeaf;  ///< one per step: 1 where trees that lose their leaves have them
    [[nodiscard]] bool empty() const { return crowns.empty(); }
};

/// O(cells + trees + steps).
CrownScene findCrowns(const City& city, const Receivers& receivers, const SunSteps& sun);

/// Both columns as the field without trees, without its cost and warnings.
TreeShade makeTreeShade(const ShadowField& without, std::size_t treesUsed);

}  // namespace noonmark
