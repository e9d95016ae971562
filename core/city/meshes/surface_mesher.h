#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/city/meshes/mesh.h"

namespace noonmark {

/// A polygon in space: indices of points; the first ring bounds it, the others are holes in it.
using Surface = std::vector<std::vector<std::uint32_t>>;

/// Makes one triangle mesh of many planar polygons that share points. Neighbours share the mesh's points too,
/// so that a closed shell stays closed by index.
class SurfaceMesher {
public:
    enum class Outcome {
        added,
        mended,      ///< crosses itself in its own plane; the crossings became points
        tangled,     ///< crosses itself in more than mostMeshCrossings points (triangulate.h): nothing added
        degenerate,  ///< no area, or a point that is no number: nothing added
    };

    /// `points` in local metres; not owned, must outlive the mesher.
    explicit SurfaceMesher(std::span<const glm::dvec3> points) : points_(points) {}

    /// Triangulates in the plane of the first ring's area normal (Newell), so vertical and slightly bent
    /// polygons work. The triangles look to where the first ring runs counter-clockwise. Indices must be in
    /// range.
    Outcome add(const Surface& surface);

    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
    TriangleMesh take() { return std::move(mesh_); }

private:
    std::uint32_t meshIndex(std::uint32_t point);
    bool addConvexQuad(const std::vector<std::uint32_t>& ring, glm::dvec3 normal);
    Outcome addTriangulated(const Surface& surface, glm::dvec3 normal);

    std::span<const glm::dvec3> points_;
    TriangleMesh mesh_;
    std::unordered_map<std::uint32_t, std::uint32_t> indexOfPoint_;
};

}  // namespace noonmark
