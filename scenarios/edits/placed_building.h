#pragma once

#include <glm/vec2.hpp>

#include "core/base/result.h"
#include "core/city/city.h"

namespace noonmark {

/// A placement of a shape: scale, then turn, both about `about`, then move.
struct Placement {
    glm::dvec2 about{0, 0};   ///< local metres
    double scale = 1;         ///< same for all three axes, heights from z = 0; 0.001 to 1000
    double clockwiseDeg = 0;  ///< seen from above
    glm::dvec2 byM{0, 0};     ///< east, north
    bool operator==(const Placement&) const = default;
};

/// Where a placement puts a point of the shape.
glm::dvec2 applyTo(glm::dvec2 point, const Placement& placement);

/// Returns the building at its placement. Outlines that rounding to float32 broke are repaired; an outline
/// that falls into pieces becomes several parts. The identity placement returns the building unchanged.
Building placeBuilding(const Building& building, const Placement& placement);

/// Raises the whole building by `byM`, or lowers it where `byM` is negative.
Building liftBuilding(Building building, double byM);

/// Changes the height of a building above `groundM` (local z). Prisms: parts that reach the highest point get
/// the new height, and everything above it is cut off. If any part is a mesh, the whole building is stretched
/// instead. The height source of every changed part becomes `designed`. Error: a height outside 0.1 to 2000
/// m, or no part begins below the new height.
Result<Building> withHeight(const Building& building, double groundM, double heightM);

/// The centroid of the outlines' area, local metres.
glm::dvec2 findMiddle(const Building& building);

}  // namespace noonmark
