#include <cstddef>

#include "core/city/city.h"
#include "core/city/triangulate.h"

namespace noonmark {

namespace {

using Index = std::uint32_t;

void addCap(TriangleMesh& mesh, const Triangulation& cap, float z, bool facingUp) {
    const Index first = Index(mesh.vertices.size());
    for (const glm::vec2 point : cap.points) mesh.vertices.emplace_back(point.x, point.y, z);
    for (glm::uvec3 triangle : cap.triangles) {
        if (!facingUp) std::swap(triangle.y, triangle.z);
        mesh.triangles.push_back(triangle + first);
    }
}

// The caps list the rings' own points first and in order, so walls reuse them: the solid is closed by index.
void addWalls(TriangleMesh& mesh, const Ring& ring, Index bottom, Index top) {
    const Index count = Index(ring.size());
    for (Index i = 0; i < count; ++i) {
        const Index j = (i + 1) % count;
        mesh.triangles.emplace_back(bottom + i, bottom + j, top + j);
        mesh.triangles.emplace_back(bottom + i, top + j, top + i);
    }
}

TriangleMesh extruded(const Part& part) {
    TriangleMesh mesh;
    const Triangulation cap = triangulated(part.footprint);
    addCap(mesh, cap, part.bottomM, false);
    addCap(mesh, cap, part.topM, true);
    const Index top = Index(cap.points.size());
    addWalls(mesh, part.footprint.outer, 0, top);
    Index first = Index(part.footprint.outer.size());
    for (const Ring& hole : part.footprint.holes) {
        addWalls(mesh, hole, first, top + first);
        first += Index(hole.size());
    }
    return mesh;
}

void append(TriangleMesh& all, const TriangleMesh& one) {
    const Index first = Index(all.vertices.size());
    all.vertices.insert(all.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (const glm::uvec3 triangle : one.triangles) all.triangles.push_back(triangle + first);
}

}  // namespace

TriangleMesh meshOf(const Part& part) { return part.mesh ? *part.mesh : extruded(part); }

CityMesh meshOf(const City& city) {
    CityMesh all;
    for (std::size_t i = 0; i < city.buildings.size(); ++i) {
        for (const Part& part : city.buildings[i]->parts) append(all.mesh, meshOf(part));
        all.buildingOfTriangle.resize(all.mesh.triangles.size(), Index(i));
    }
    return all;
}

}  // namespace noonmark
