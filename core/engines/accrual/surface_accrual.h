#pragma once

#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/api/surface_engine.h"
#include "core/engines/graph/direction_graph.h"
#include "core/engines/graph/interval_tally.h"

namespace noonmark {

/// Shadow accrual maps on any surface (paper, section 4), on the processor, for exploration. Each interval
/// has its own frame at a right angle to the sun's direction, warped towards the eye if the points have one.
/// Error: half a texel at the border of shadows, the straight sun path, and the direction graph where hours
/// share an edge. Running results go to the PartialSink of `progress` as a field with one row, one cell per
/// point.
class SurfaceAccrual final : public SurfaceEngine {
public:
    /// Error if a setting of the maps is out of range.
    static Result<std::unique_ptr<SurfaceAccrual>> make(const AccrualSettings& settings,
                                                        const DirectionGraphSettings& graph);

    [[nodiscard]] Result<SurfaceShadow> accumulate(const City& city, const SurfacePoints& points,
                                                   const SunSteps& sun, Progress& progress,
                                                   std::stop_token stop) const override;
    [[nodiscard]] Result<SurfaceShadow> accumulate(const City& city, const SurfacePoints& points,
                                                   const SunSteps& sun, Progress& progress,
                                                   std::stop_token stop,
                                                   const StepMemory& memory) const override;

private:
    SurfaceAccrual(const AccrualSettings& settings, const DirectionGraphSettings& graph);
    AccrualSettings settings_;
    DirectionGraphSettings graph_;
};

}  // namespace noonmark
