#include "core/city/meshes/extrude.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "core/city/city.h"
#include "core/city/footprints/triangulate.h"

namespace noonmark {

// With holes the caps must be triangulated: a hole may touch the outline or another hole in a corner or along
// an edge, which changes the count.
std::size_t countTriangles(const Part& part) {
    if (part.mesh) return part.mesh->triangles.size();
    const std::size_t points = part.footprint.outer.size();
    if (part.footprint.holes.empty() && points >= 3) return 2 * (points - 2) + 2 * points;
    return meshOf(part).triangles.size();
}

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

using Edge = std::pair<Index, Index>;

// Edges of the cap with a triangle on one side only, that triangle on their left. These are not simply the
// rings' edges: where a hole's corner touches the middle of an edge, the cap has two edges there, and the
// walls must have the same two for the solid to be closed.
std::vector<Edge> computeOutline(const Triangulation& cap) {
    std::vector<Edge> edges;
    edges.reserve(cap.triangles.size() * 3);
    for (const glm::uvec3 t : cap.triangles) edges.insert(edges.end(), {{t.x, t.y}, {t.y, t.z}, {t.z, t.x}});
    std::sort(edges.begin(), edges.end());
    const auto isInner = [&](Edge e) {
        return std::binary_search(edges.begin(), edges.end(), Edge(e.second, e.first));
    };
    std::vector<Edge> outline;
    std::copy_if(edges.begin(), edges.end(), std::back_inserter(outline), std::not_fn(isInner));
    return outline;
}

// The walls use the points of the two caps, whose indices differ by `top`, so that the solid is closed by
// index.
TriangleMesh extrude(const Part& part) {
    TriangleMesh mesh;
    const Triangulation cap = triangulate(part.footprint);
    addCap(mesh, cap, part.bottomM, false);
    addCap(mesh, cap, part.topM, true);
    const Index top = Index(cap.points.size());
    for (const auto& [from, to] : computeOutline(cap)) {
        mesh.triangles.emplace_back(from, to, top + to);
        mesh.triangles.emplace_back(from, top + to, top + from);
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

TriangleMesh meshOf(const Part& part) { return part.mesh ? *part.mesh : extrude(part); }

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
