#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/common/shadow_mask.h"
#include "core/engines/graph/direction_graph.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// One interval on a day's path, with what its masks came to.
struct PathLeg {
    std::span<const MaskRuns> runs;  ///< one a receiver
    int steps = 0;
    bool breaksRun = false;  ///< a run cannot cross into it
};

/// Gross and continuous shadow of every receiver, put together from intervals (paper, section 6): gross is
/// the sum over the intervals, continuous is stitched along each day. At any time it is the true tally of
/// what was added so far. 12 bytes a receiver; adding uses all cores.
class IntervalTally {
public:
    explicit IntervalTally(std::size_t receivers) : gross_(receivers), longest_(receivers) {}

    /// The runs of one edge's masks, its gross shadow counted for every interval that takes it.
    std::vector<MaskRuns> addEdge(std::span<const ShadowMask> masks, const DirectionGraph::Edge& edge);

    /// A day whose edges were all added.
    void addPath(const std::vector<PathLeg>& legs);

    [[nodiscard]] std::uint64_t intervals() const { return intervals_; }  ///< of the period, added so far
    [[nodiscard]] std::uint64_t steps() const { return steps_; }          ///< of these

    /// Minutes into a field over these receivers; `legs` belong to a day that was not added yet, in order.
    void writeTo(ShadowField& field, const Receivers& receivers, const std::vector<PathLeg>& legs) const;

private:
    std::vector<std::uint64_t> gross_;
    std::vector<std::uint32_t> longest_;
    std::uint64_t intervals_ = 0;
    std::uint64_t steps_ = 0;
};

}  // namespace noonmark
