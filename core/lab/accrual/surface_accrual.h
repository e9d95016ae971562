#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/api/engine.h"
#include "core/engines/depths/depth_slice.h"
#include "core/engines/depths/map_frame.h"
#include "core/lab/accrual/accrual_settings.h"
#include "core/lab/graph/direction_graph.h"
#include "core/lab/graph/interval_tally.h"

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

/// The data that a step's lookup of a surface needs besides the points and the map.
struct SurfaceView {
    float shearX, shearY;
    float column[3], row[3], q[3];  ///< rows of texelFromPlane
    float perQ[3];                  ///< 1 / q of a texel's centre, from (column, row, 1)
    float sun[3];                   ///< in the frame's axes
    float biasM;
    float slopeM;  ///< slope bias x metres per texel at q = 1 x sun[2]
    int columns, rows;
    int stride;
};

/// Surface points in the frame of an interval's maps, for lookups: one array per coordinate, padded with
/// unused points to whole words of 64.
struct PlacedSurface {
    std::vector<float> x, y, w;              ///< MapFrame::placed, metres
    std::vector<float> across, up, towards;  ///< normals in the axes u, v, normal of the frame
    std::size_t count = 0;                   ///< without the padding
    float lowestW = 0;
};
PlacedSurface placeSurface(const SurfacePoints& points, const MapFrame& frame);

/// Determines which points of a surface are in shadow at a step.
class SurfaceLookup {
public:
    SurfaceLookup(PlacedSurface surface, const MapFrame& frame, const AccrualSettings& settings);

    [[nodiscard]] const PlacedSurface& surface() const { return surface_; }

    /// Bit i % 64 of shaded[i / 64]: point i faces away from the sun, or an occluder is closer to the sun
    /// than the point by more than the bias. Bits after the last point are 0.
    void look(const DepthSlice& slice, glm::dvec3 towardsSun, std::span<std::uint64_t> shaded) const;

private:
    PlacedSurface surface_;
    MapFrame frame_;
    float biasM_;
    float slopeBias_;
};

}  // namespace noonmark
