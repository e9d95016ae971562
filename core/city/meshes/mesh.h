#pragma once

// The folder core/city/meshes handles triangle meshes. TriangleMesh (this file) is the plain data. Making
// meshes: surface_mesher.h, from prisms and from polygons in space. Turning a mesh as read into parts
// of a building: mesh_parts.h, which also cuts off eaves, with weld, orientation and surfaces without
// thickness in mesh_topology.h, and the outline seen from above in mesh_outline.h. mesh_section.h cuts a mesh
// horizontally.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace noonmark {

/// Triangles in local metres (z up). Counter-clockwise faces point outward.
struct TriangleMesh {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;  ///< indices into vertices
    bool operator==(const TriangleMesh&) const = default;
};

}  // namespace noonmark
