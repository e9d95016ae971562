#pragma once

#include <optional>

#include "core/city/building.h"
#include "core/city/terrain/terrain.h"

namespace noonmark {

/// The lowest ground under a building's outline, local z: at its corners, and at up to 1,024 places inside
/// each part.
float findLowestGround(const Building& building, const Terrain& terrain);

/// The building on the ground. With terrain: one without a ground of its own (`groundM`, local z) is lifted
/// as a whole by the lowest ground under it; of one that has it the earth's curvature is taken off
/// (earth_drop.h), and the standing walls go down to the terrain where that is lower (a mesh keeps its
/// shape). Without terrain the ground is flat at z = 0, and a ground of its own is taken off.
Building standOnTerrain(Building building, std::optional<float> groundM, const Terrain* terrain);

}  // namespace noonmark
