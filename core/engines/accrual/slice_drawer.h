#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/engines/accrual/depth_slice.h"
#include "core/engines/accrual/interval_casters.h"

namespace noonmark {

/// What drawing a slice took.
struct SliceCost {
    std::uint64_t faces = 0;
    std::uint64_t rows = 0;
};

/// Draws slices; one a thread.
class SliceDrawer {
public:
    /// The depth map of the sun that makes this shear; clears the slice first. The same for the same
    /// arguments, to the last bit, whoever draws it.
    SliceCost draw(const IntervalCasters& casters, const MapFrame& frame, glm::dvec2 shear, CasterSide side,
                   DepthSlice& slice);

private:
    /// A point as the map of this step sees it.
    struct Seen {
        glm::dvec3 texel;  ///< MapFrame::homogeneous
        double depth;      ///< w, undivided
    };
    void drawFace(const CasterFace& face, CasterSide side, DepthSlice& slice, SliceCost& cost);

    std::vector<Seen> seen_;
    DepthPen pen_;
};

}  // namespace noonmark
