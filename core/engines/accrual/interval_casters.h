#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/accrual/caster_faces.h"
#include "core/engines/accrual/map_frame.h"
#include "core/engines/common/interval_engine.h"

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
IntervalCasters placeCasters(const CasterFaces& faces, const std::vector<glm::dvec3>& placed,
                             const MapFrame& frame, const SunInterval& interval, CasterSide side,
                             const ReceiverExtent& receivers);

}  // namespace noonmark
