#pragma once

// Shadow accrual maps (paper, section 4): for each interval of the sun, a stack of depth maps that differ
// only by a shear. In core/engines/depths caster_faces.h lists the faces of a city, and culls and places them
// for one interval in the frame of map_frame.h, which may be warped towards the eye. slice_stack.h draws one
// depth map (depth_slice.h) per step, for all steps of an interval. ShadowAccrualMap (this file) reads the
// shadow of ground grids from them, SurfaceAccrual (surface_accrual.h) that of points on any surface.
// accrual_settings.h holds the settings. sun_depth_map.h draws a single depth map for shadows in pictures.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/engines/depths/depth_slice.h"
#include "core/engines/depths/map_frame.h"
#include "core/lab/accrual/accrual_settings.h"
#include "core/lab/graph/interval_engine.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// The cells of flat ground in the maps. They lie on the map's plane, so the texel of a cell is the same at
/// every step.
class GroundLookup {
public:
    GroundLookup(const Receivers& receivers, const MapFrame& frame, float biasM);

    /// Number of words with one bit per receiver.
    [[nodiscard]] std::size_t words() const { return (texel_.size() + 63) / 64; }

    /// Bit i % 64 of shaded[i / 64]: an occluder is closer to the sun than receivers.cells[i] by more than
    /// the bias. Bits after the last receiver are 0.
    void look(const DepthSlice& slice, std::span<std::uint64_t> shaded) const;

    /// Index in DepthSlice::depth of each receiver's texel.
    [[nodiscard]] std::span<const std::uint32_t> texels() const { return texel_; }

private:
    float biasM_;
    std::vector<std::uint32_t> texel_;  // indices in DepthSlice::depth
};

/// Shadow accrual maps (paper, section 4) on the processor, for flat ground. The city is transformed once per
/// interval. Each step of the interval is a slice, a depth map that differs from the others only by a shear;
/// slices are drawn in parallel on all cores. Each slice is looked up as soon as it is drawn, so only one per
/// thread is in memory. Error: the straight sun path and, if texels are not aligned with cells, half a texel.
class ShadowAccrualMap final : public IntervalEngine {
public:
    /// Error if a setting is out of range.
    static Result<std::shared_ptr<const ShadowAccrualMap>> make(const AccrualSettings& settings);

    [[nodiscard]] Result<std::unique_ptr<IntervalScene>> prepare(const City& city, const Receivers& receivers,
                                                                 const SunSteps& directions,
                                                                 std::stop_token stop) const override;
    [[nodiscard]] std::string_view name() const override { return "Shadow accrual map"; }
    [[nodiscard]] std::string describe() const override;

private:
    explicit ShadowAccrualMap(AccrualSettings settings);
    AccrualSettings settings_;
};

}  // namespace noonmark
