#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/common/run_counter.h"
#include "core/lab/graph/direction_graph.h"
#include "core/receivers/receivers.h"

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

/// One interval on a day's path, with the runs of its masks.
struct PathLeg {
    std::span<const MaskRuns> runs;  ///< one per receiver
    int steps = 0;
    bool breaksRun = false;  ///< runs do not continue into it
};

/// Combines intervals into gross and continuous shadow of every receiver (paper, section 6): gross shadow is
/// the sum over the intervals, continuous shadow is stitched along each day. At any time it is the exact
/// result for the intervals added so far. 12 bytes per receiver; adding uses all cores.
class IntervalTally {
public:
    explicit IntervalTally(std::size_t receivers) : gross_(receivers), longest_(receivers) {}

    /// Adds an edge's gross shadow for every interval on it and returns the runs of its masks.
    std::vector<MaskRuns> addEdge(std::span<const ShadowMask> masks, const DirectionGraph::Edge& edge);

    /// Adds a day whose edges have all been added.
    void addPath(const std::vector<PathLeg>& legs);

    /// Intervals of the period added so far, and their steps.
    [[nodiscard]] std::uint64_t intervals() const { return intervals_; }
    [[nodiscard]] std::uint64_t steps() const { return steps_; }

    /// Writes minutes to a field over these receivers; `legs`, in order, belong to a day that has not been
    /// added yet.
    void writeTo(ShadowField& field, const Receivers& receivers, const std::vector<PathLeg>& legs) const;

private:
    std::vector<std::uint64_t> gross_;
    std::vector<std::uint32_t> longest_;
    std::uint64_t intervals_ = 0;
    std::uint64_t steps_ = 0;
};

}  // namespace noonmark
