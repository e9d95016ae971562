#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/city/city.h"
#include "core/city/meshes/mesh.h"

namespace noonmark {

/// A polygon in space as indices of points: the outer ring first, then its holes.
using Surface = std::vector<std::vector<std::uint32_t>>;

/// Triangulates many planar polygons that share points into one mesh. Neighbours share the mesh's points too,
/// so that a closed shell stays closed by index.
class SurfaceMesher {
public:
    enum class Outcome {
        added,
        repaired,    ///< the polygon crosses itself in its own plane; the crossings became points
        tangled,     ///< more than maxMeshCrossings crossings (triangulate.h): nothing added
        degenerate,  ///< no area, or a point that is not a number: nothing added
    };

    /// `points` in local metres; not owned, must outlive the mesher.
    explicit SurfaceMesher(std::span<const glm::dvec3> points) : points_(points) {}

    /// Triangulates in the plane of the first ring's area normal (Newell), so that vertical and slightly bent
    /// polygons work. The triangles face the side from which the first ring runs counter-clockwise. Indices
    /// must be in range.
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

/// The number of triangles of meshOf(part), without making them if the outline has no holes: a simple polygon
/// of v points has v - 2 triangles; a prism has two such polygons and 2 v triangles in its walls.
std::size_t countTriangles(const Part& part);

}  // namespace noonmark
