#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/engines/accrual/depth_slice.h"
#include "core/engines/accrual/interval_casters.h"

namespace noonmark {

/// The work done to draw a slice.
struct SliceCost {
    std::uint64_t faces = 0;
    std::uint64_t rows = 0;
};

/// Draws slices; one per thread.
class SliceDrawer {
public:
    /// Clears the slice and draws the depth map of the sun direction with this shear. The result depends only
    /// on the arguments, to the last bit.
    SliceCost draw(const IntervalCasters& casters, const MapFrame& frame, glm::dvec2 shear, CasterSide side,
                   DepthSlice& slice);

private:
    /// A point in the map of this step.
    struct Seen {
        glm::dvec3 texel;  ///< MapFrame::homogeneous
        double depth;      ///< w, not divided by q
    };
    void drawFace(const CasterFace& face, CasterSide side, DepthSlice& slice, SliceCost& cost);

    std::vector<Seen> seen_;
    DepthPen pen_;
};

}  // namespace noonmark
