#pragma once

// The direction graph (paper, section 6): computes long periods from short intervals. direction_graph.h
// divides the sky into bins and merges a period's intervals between the same bins into edges. GraphEngine
// (this file) shades each edge once with an IntervalEngine. interval_tally.h combines the results; for
// running results it reuses those of a coarser view.

#include <memory>

#include "core/engines/api/engine.h"
#include "core/lab/graph/direction_graph.h"
#include "core/lab/graph/interval_engine.h"
#include "core/lab/graph/interval_tally.h"

namespace noonmark {

/// Every direction of every edge, for IntervalEngine::prepare.
SunSteps collectDirections(const DirectionGraph& graph);

/// Shortens the intervals if steps are shorter than a minute, because a mask holds 64 steps.
DirectionGraphSettings fitToMasks(DirectionGraphSettings settings, double stepMinutes);

/// The settings of an interval engine with those of the graph that it is used through.
template <class S>
struct ThroughGraph {
    S own;
    DirectionGraphSettings graph;
};

template <class S>
Fields<ThroughGraph<S>> throughGraph(const Fields<S>& own) {
    return Fields<ThroughGraph<S>>{}
        .embed(&ThroughGraph<S>::own, own)
        .embed(&ThroughGraph<S>::graph, graphFields());
}

/// Computes long periods from short intervals (paper, section 6): an interval engine shades every edge of the
/// direction graph once; gross shadow is the weighted sum, continuous shadow is stitched along each day's
/// path. Masks live from the first path that needs them to the last. `cost.skipped` states how many intervals
/// shared an edge, and the stage text how many maps were alive at most.
class GraphEngine final : public Engine {
public:
    GraphEngine(std::shared_ptr<const IntervalEngine> engine, DirectionGraphSettings settings);
    [[nodiscard]] std::string_view name() const override { return engine_->name(); }
    [[nodiscard]] EngineCapabilities capabilities() const override { return engine_->capabilities(); }
    using Engine::accumulate;
    /// The same result; on the way it shows, and remembers, what `memory` says.
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop, const StepMemory& memory) const;

protected:
    [[nodiscard]] Result<ShadowField> compute(const City& city, const Receivers& receivers,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const override;

private:
    std::shared_ptr<const IntervalEngine> engine_;
    DirectionGraphSettings settings_;
};

}  // namespace noonmark
