#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/engines/common/shadow_mask.h"
#include "core/engines/graph/direction_graph.h"

namespace noonmark {

/// Shadow at every step, by edge of a direction graph and receiver. 8 bytes a receiver and edge.
using EdgeMasks = std::vector<std::vector<ShadowMask>>;

/// What is known already of places near each receiver: running results over one day show it for the steps to
/// come, so that they tell of the whole day and grow finer with each step.
struct StepsAround {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::shared_ptr<const EdgeMasks> masks;  ///< found over the same steps through the same graph
    std::vector<std::uint32_t> nearest;      ///< of each receiver, in `masks`; none: it is shown as lit

    /// Of each receiver at one edge.
    [[nodiscard]] std::vector<ShadowMask> at(std::uint32_t edge) const {
        std::vector<ShadowMask> here;
        here.reserve(nearest.size());
        for (const std::uint32_t near : nearest) here.push_back(near == none ? 0 : (*masks)[edge][near]);
        return here;
    }
};

/// Whether a period is one that running results can tell the whole of: a day that takes each edge once.
inline bool isOneDay(const DirectionGraph& graph) {
    return graph.paths.size() == 1 && graph.intervals == graph.edges.size();
}

/// What an accumulation remembers from one view to the next, finer one.
struct StepMemory {
    const StepsAround* around = nullptr;  ///< of the coarser view; null: nothing
    EdgeMasks* found = nullptr;           ///< filled where the period is one day; null: not wanted
};

}  // namespace noonmark
