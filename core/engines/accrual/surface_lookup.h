#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/accrual/depth_slice.h"
#include "core/engines/accrual/map_frame.h"

namespace noonmark {

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
