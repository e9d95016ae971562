#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/city/mesh.h"
#include "core/receivers/grid.h"

namespace noonmark {

/// The ground as a grid of elevations. Between cell centres it is the surface of meshOf's triangles, so
/// that what stands on the ground and what the ground shades agree; beyond the outer centres the nearest
/// value.
struct Terrain {
    Grid grid;
    std::vector<float> elevationM;  ///< local z at cell centres, grid order (row 0 south); all finite

    bool operator==(const Terrain&) const = default;
};

/// Local z of the ground at a point, metres.
float elevationAt(const Terrain& terrain, glm::dvec2 point);

/// Two triangles a cell between centres, outward = up. 2 (columns - 1)(rows - 1) triangles.
TriangleMesh meshOf(const Terrain& terrain);

}  // namespace noonmark
