#pragma once

#include <glm/vec2.hpp>

#include "core/base/result.h"
#include "core/city/building.h"

namespace noonmark {

/// Where a shape is put: scaled, then turned, both about `about`, then moved.
struct Placement {
    glm::dvec2 about{0, 0};   ///< local metres
    double scale = 1;         ///< of all three axes, heights from z = 0; 0.001 to 1000
    double clockwiseDeg = 0;  ///< seen from above
    glm::dvec2 byM{0, 0};     ///< east, north
    bool operator==(const Placement&) const = default;
};

/// The building put there. Outlines are repaired again where rounding to float32 broke them; one that falls
/// into pieces becomes several parts. A placement that leaves all as it is gives the same building back.
Building placed(const Building& building, const Placement& placement);

/// The building higher or lower by `byM` as a whole.
Building lifted(Building building, double byM);

/// With `groundM` the local z that heights count from. Prisms: the parts that reach the highest point go up
/// to the new height; what stands above it is cut off. Where a part is a mesh, all is stretched instead. The
/// height of every part that changes is `designed`.
/// Error: no height (0.1 to 2000 m), or nothing of the building is that low.
Result<Building> withHeight(const Building& building, double groundM, double heightM);

/// The middle of the outlines' area, local metres.
glm::dvec2 findMiddle(const Building& building);

}  // namespace noonmark
