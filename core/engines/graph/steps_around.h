#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/engines/common/shadow_mask.h"
#include "core/engines/graph/direction_graph.h"

namespace noonmark {

/// Shadow at every step, by edge of a direction graph and receiver. 8 bytes per receiver and edge.
using EdgeMasks = std::vector<std::vector<ShadowMask>>;

/// Known results near each receiver. Running results for one day use them for the steps that are not
/// finished, so that they cover the whole day and become more accurate with each step.
struct StepsAround {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::shared_ptr<const EdgeMasks> masks;  ///< computed for the same steps with the same graph
    std::vector<std::uint32_t> nearest;      ///< for each receiver an index in `masks`; none: shown as lit

    /// Masks of all receivers at one edge.
    [[nodiscard]] std::vector<ShadowMask> at(std::uint32_t edge) const {
        std::vector<ShadowMask> here;
        here.reserve(nearest.size());
        for (const std::uint32_t near : nearest) here.push_back(near == none ? 0 : (*masks)[edge][near]);
        return here;
    }
};

/// Whether running results can cover the whole period: a single day that uses each edge once.
inline bool isOneDay(const DirectionGraph& graph) {
    return graph.paths.size() == 1 && graph.intervals == graph.edges.size();
}

/// Data passed from the accumulation of one view to that of the next, finer one.
struct StepMemory {
    const StepsAround* around = nullptr;  ///< from the coarser view; null: nothing known
    EdgeMasks* found = nullptr;           ///< filled if the period is one day; null: not needed
};

}  // namespace noonmark
