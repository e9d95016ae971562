#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "core/accumulate/accrual/accrual_settings.h"
#include "core/accumulate/accrual/caster_faces.h"
#include "core/accumulate/accrual/depth_slice.h"
#include "core/accumulate/accrual/map_frame.h"
#include "core/accumulate/interval_engine.h"

namespace noonmark {

/// The receivers of an interval, as far as culling must know them.
struct ReceiverExtent {
    double lowestW = 0;  ///< height before the map's plane of the lowest: what lies below shades nothing
    /// Whether a receiver may lie in this box of the map's plane, metres; null: anywhere on the map.
    std::function<bool(glm::dvec2 low, glm::dvec2 high)> any;
};

/// The faces that may darken a receiver at some step of an interval, placed in the frame of its maps: what
/// all its slices are drawn from.
struct IntervalCasters {
    std::vector<glm::dvec3> points;  ///< MapFrame::placed
    std::vector<CasterFace> faces;   ///< corners into `points`
    std::uint64_t turnedOther =
        0;  ///< faces left out: never on the side that is drawn, or below all receivers
    std::uint64_t outOfReach = 0;  ///< faces left out: their shadow meets no receiver
};

/// Never leaves out what could darken a receiver. In an interval every point's shadow moves on a straight
/// line, so the places of both ends bound it. O(faces). `placed`: MapFrame::placed of faces.points.
IntervalCasters castersOf(const CasterFaces& faces, const std::vector<glm::dvec3>& placed,
                          const MapFrame& frame, const SunInterval& interval, CasterSide side,
                          const ReceiverExtent& receivers);

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
