#pragma once

#include "core/city/building.h"

namespace noonmark {

/// The gross floor area of a building that is divided into storeys of one height.
struct FloorArea {
    double grossM2 = 0;
    int storeys = 0;  ///< storeys that have a floor
    /// How many of them were estimated since a mesh is not closed (mesh_section.h)
    int estimatedStoreys = 0;
};

/// Computes the gross floor area of a building with storeys of `storeyHeightM` (above 0) from `groundM`
/// (local z) up. The floor of storey k is the union of the floors of all parts that reach through the middle
/// of the storey: for a prism its footprint; for a mesh its section 1 cm above the storey's floor, or 1 cm
/// above the mesh's foot if that is higher. Parts that overlap count once. Prisms cost next to nothing; a
/// mesh some ms for a hundred storeys.
FloorArea computeFloorArea(const Building& building, double groundM, double storeyHeightM);

/// The floor of storey 0, as computeFloorArea() counts it.
std::vector<Footprint> findGroundFloor(const Building& building, double groundM, double storeyHeightM);

}  // namespace noonmark
