#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/accrual/depth_slice.h"
#include "core/engines/accrual/map_frame.h"

namespace noonmark {

/// Surface points in the frame of an interval's maps, as lookups take them: one array a coordinate, padded to
/// whole words of 64 with points that nobody asks for.
struct PlacedSurface {
    std::vector<float> x, y, w;              ///< MapFrame::placed, metres
    std::vector<float> across, up, towards;  ///< normals in the axes u, v, normal of the frame
    std::size_t count = 0;                   ///< without the padding
    float lowestW = 0;
};
PlacedSurface placeSurface(const SurfacePoints& points, const MapFrame& frame);

/// Finds out which points of a surface are in shadow at a step.
class SurfaceLookup {
public:
    SurfaceLookup(PlacedSurface surface, const MapFrame& frame, const AccrualSettings& settings);

    [[nodiscard]] const PlacedSurface& surface() const { return surface_; }

    /// Bit i % 64 of shaded[i / 64]: point i is turned away from the sun, or something is more than the bias
    /// before it. Bits beyond the last are 0.
    void look(const DepthSlice& slice, glm::dvec3 towardsSun, std::span<std::uint64_t> shaded) const;

private:
    PlacedSurface surface_;
    MapFrame frame_;
    float biasM_;
    float slopeBias_;
};

}  // namespace noonmark
