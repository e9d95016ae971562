#pragma once

#include <optional>

#include "core/city/building.h"
#include "core/city/terrain/terrain.h"

namespace noonmark {

/// Moves a building up.
void lift(Building& building, float byM);

/// The lowest ground under a building's outline, local z: of its corners, and of up to 1,024 points inside
/// each part.
float findLowestGround(const Building& building, const Terrain& terrain);

/// Places a building on the ground. With terrain: a building without a stated ground (`groundM`, local z) is
/// lifted as a whole by the lowest ground under it. One with a stated ground is lowered by the earth's
/// curvature (earth_drop.h), and its standing walls are extended down to the terrain where that is lower (a
/// mesh keeps its shape). Without terrain the ground is flat at z = 0, and a stated ground is subtracted.
Building standOnTerrain(Building building, std::optional<float> groundM, const Terrain* terrain);

}  // namespace noonmark
