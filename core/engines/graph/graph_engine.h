#pragma once

#include <memory>

#include "core/engines/api/engine.h"
#include "core/engines/common/interval_engine.h"
#include "core/engines/graph/direction_graph.h"
#include "core/engines/graph/steps_around.h"

namespace noonmark {

/// Long periods from short intervals (paper, section 6): every edge of the direction graph is shaded once by
/// an interval engine; gross is the weighted sum, continuous is stitched along each day's path. Masks live
/// from the first path that needs them to the last: `cost.skipped` says how many intervals shared an edge,
/// and the stage text how many maps were alive at most.
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
