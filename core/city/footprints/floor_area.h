#pragma once

#include "core/city/building.h"

namespace noonmark {

/// What a building holds, cut into storeys of one height.
struct FloorArea {
    double grossM2 = 0;
    int storeys = 0;           ///< with a floor
    int estimatedStoreys = 0;  ///< of these, where a mesh is not closed (mesh_section.h)
};

/// The gross floor area of a building cut into storeys of `storeyHeightM` (over 0) from `groundM` (local z)
/// up. Storey k has the floor of each part that reaches through the storey's middle: a prism's footprint; a
/// mesh's section at the floor, 1 cm above it, or at the mesh's foot where that is higher. Parts that overlap
/// count once. Prisms cost nothing; a mesh some ms for a hundred storeys.
FloorArea computeFloorArea(const Building& building, double groundM, double storeyHeightM);

/// The floor of storey 0: what computeFloorArea() counts there.
std::vector<Footprint> findGroundFloor(const Building& building, double groundM, double storeyHeightM);

}  // namespace noonmark
