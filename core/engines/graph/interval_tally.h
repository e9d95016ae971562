#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/common/shadow_mask.h"
#include "core/engines/graph/direction_graph.h"
#include "core/receivers/receivers.h"

namespace noonmark {

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
