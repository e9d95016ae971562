#include <tbb/parallel_for.h>

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

TriangleMesh meshOfParts(const Building& building) {
    TriangleMesh all;
    for (const Part& part : building.parts) append(all, meshOf(part));
    return all;
}

std::vector<TriangleMesh> meshesOf(const City& city, const std::stop_token& stop) {
    std::vector<TriangleMesh> meshes(city.buildings.size());
    tbb::parallel_for(std::size_t{0}, meshes.size(), [&](std::size_t i) {
        if (!stop.stop_requested()) meshes[i] = meshOfParts(*city.buildings[i]);
    });
    return meshes;
}

CityMesh withRoomFor(const std::vector<TriangleMesh>& meshes) {
    std::size_t vertices = 0, triangles = 0;
    for (const TriangleMesh& mesh : meshes) {
        vertices += mesh.vertices.size();
        triangles += mesh.triangles.size();
    }
    CityMesh all;
    all.mesh.vertices.reserve(vertices);
    all.mesh.triangles.reserve(triangles);
    all.buildingOfTriangle.reserve(triangles);
    return all;
}

}  // namespace

TriangleMesh meshOf(const Part& part) { return part.mesh ? *part.mesh : extruded(part); }

CityMesh meshOf(const City& city, const std::stop_token& stop) {
    const std::vector<TriangleMesh> meshes = meshesOf(city, stop);
    CityMesh all = withRoomFor(meshes);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        append(all.mesh, meshes[i]);
        all.buildingOfTriangle.resize(all.mesh.triangles.size(), Index(i));
    }
    return all;
}

}  // namespace noonmark
