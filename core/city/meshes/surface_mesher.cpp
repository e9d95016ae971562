#include "core/city/meshes/surface_mesher.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

#include "core/city/footprints/triangulate.h"

namespace noonmark {

namespace {

using IndexRing = std::vector<std::uint32_t>;
using Points = std::span<const glm::dvec3>;

constexpr double minAreaM2 = 1e-7;

bool isFinite(glm::dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// Removes points that repeat the previous one; empty if fewer than three are left.
IndexRing cleaned(const IndexRing& ring, Points points) {
    IndexRing result;
    for (const auto index : ring)
        if (result.empty() || points[index] != points[result.back()]) result.push_back(index);
    while (result.size() > 1 && points[result.front()] == points[result.back()]) result.pop_back();
    if (result.size() < 3) result.clear();
    return result;
}

// Newell: a vector along the ring's normal, twice the ring's area long.
glm::dvec3 areaNormal(const IndexRing& ring, Points points) {
    glm::dvec3 sum(0);
    const glm::dvec3 origin = points[ring[0]];
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        sum += glm::cross(points[ring[i]] - origin, points[ring[i + 1]] - origin);
    return sum;
}

// The plane of a polygon, with right-handed axes u, v and the normal.
struct Plane {
    glm::dvec3 origin, u, v;
    Plane(glm::dvec3 at, glm::dvec3 normal) : origin(at) {
        const glm::dvec3 across = std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
        u = glm::normalize(glm::cross(across, normal));
        v = glm::cross(normal, u);
    }
    [[nodiscard]] glm::vec2 project(glm::dvec3 point) const {
        return {float(glm::dot(point - origin, u)), float(glm::dot(point - origin, v))};
    }
    [[nodiscard]] glm::dvec3 lift(glm::vec2 point) const {
        return origin + double(point.x) * u + double(point.y) * v;
    }
};

Ring projectRing(const IndexRing& ring, Points points, const Plane& plane) {
    Ring result;
    for (const auto index : ring) result.push_back(plane.project(points[index]));
    return result;
}

Surface cleaned(const Surface& surface, Points points) {
    Surface result;
    for (const IndexRing& ring : surface) {
        for (const auto index : ring)
            if (!isFinite(points[index])) return {};
        IndexRing clean = cleaned(ring, points);
        if (clean.empty() && result.empty()) return {};
        if (!clean.empty()) result.push_back(std::move(clean));
    }
    return result;
}

}  // namespace

std::uint32_t SurfaceMesher::meshIndex(std::uint32_t point) {
    const auto [place, isNew] = indexOfPoint_.try_emplace(point, std::uint32_t(mesh_.vertices.size()));
    if (isNew) mesh_.vertices.emplace_back(points_[point]);
    return place->second;
}

SurfaceMesher::Outcome SurfaceMesher::add(const Surface& surface) {
    const Surface clean = cleaned(surface, points_);
    if (clean.empty()) return Outcome::degenerate;
    const glm::dvec3 normal = areaNormal(clean[0], points_);
    const double doubledArea = glm::length(normal);
    if (!(doubledArea >= 2 * minAreaM2)) return Outcome::degenerate;
    if (clean.size() == 1 && clean[0].size() == 4 && addConvexQuad(clean[0], normal / doubledArea))
        return Outcome::added;
    if (clean.size() > 1 || clean[0].size() > 3) return addTriangulated(clean, normal / doubledArea);
    mesh_.triangles.emplace_back(meshIndex(clean[0][0]), meshIndex(clean[0][1]), meshIndex(clean[0][2]));
    return Outcome::added;
}

// Fast path for most walls and roofs; false if a corner is not clearly convex.
bool SurfaceMesher::addConvexQuad(const std::vector<std::uint32_t>& ring, glm::dvec3 normal) {
    constexpr double clearlyM2 = 1e-4;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 before = points_[ring[(i + 3) % 4]];
        const glm::dvec3 corner = points_[ring[i]];
        const glm::dvec3 after = points_[ring[(i + 1) % 4]];
        if (glm::dot(glm::cross(corner - before, after - corner), normal) < clearlyM2) return false;
    }
    const std::size_t first =
        glm::distance(points_[ring[0]], points_[ring[2]]) <= glm::distance(points_[ring[1]], points_[ring[3]])
            ? 0
            : 1;
    const auto corner = [&](std::size_t i) { return meshIndex(ring[(first + i) % 4]); };
    mesh_.triangles.emplace_back(corner(0), corner(1), corner(2));
    mesh_.triangles.emplace_back(corner(0), corner(2), corner(3));
    return true;
}

SurfaceMesher::Outcome SurfaceMesher::addTriangulated(const Surface& surface, glm::dvec3 normal) {
    const Plane plane(points_[surface[0][0]], normal);
    Footprint flat{projectRing(surface[0], points_, plane), {}};
    IndexRing own = surface[0];
    for (std::size_t i = 1; i < surface.size(); ++i) {
        flat.holes.push_back(projectRing(surface[i], points_, plane));
        own.insert(own.end(), surface[i].begin(), surface[i].end());
    }
    const Triangulation triangulation = triangulate(flat);
    if (triangulation.tangled) return Outcome::tangled;
    if (triangulation.triangles.empty()) return Outcome::degenerate;
    IndexRing indices;
    for (const auto index : own) indices.push_back(meshIndex(index));
    for (std::size_t i = own.size(); i < triangulation.points.size(); ++i) {
        indices.push_back(std::uint32_t(mesh_.vertices.size()));
        mesh_.vertices.emplace_back(plane.lift(triangulation.points[i]));
    }
    for (const glm::uvec3 t : triangulation.triangles)
        mesh_.triangles.emplace_back(indices[t.x], indices[t.y], indices[t.z]);
    return triangulation.points.size() > own.size() ? Outcome::repaired : Outcome::added;
}

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

using CapEdge = std::pair<Index, Index>;

// Edges of the cap with a triangle on one side only, that triangle on their left. These are not simply the
// rings' edges: where a hole's corner touches the middle of an edge, the cap has two edges there, and the
// walls must have the same two for the solid to be closed.
std::vector<CapEdge> computeOutline(const Triangulation& cap) {
    std::vector<CapEdge> edges;
    edges.reserve(cap.triangles.size() * 3);
    for (const glm::uvec3 t : cap.triangles) edges.insert(edges.end(), {{t.x, t.y}, {t.y, t.z}, {t.z, t.x}});
    std::sort(edges.begin(), edges.end());
    const auto isInner = [&](CapEdge e) {
        return std::binary_search(edges.begin(), edges.end(), CapEdge(e.second, e.first));
    };
    std::vector<CapEdge> outline;
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

void appendMesh(TriangleMesh& all, const TriangleMesh& one) {
    const Index first = Index(all.vertices.size());
    all.vertices.insert(all.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (const glm::uvec3 triangle : one.triangles) all.triangles.push_back(triangle + first);
}

TriangleMesh meshOfParts(const Building& building) {
    TriangleMesh all;
    for (const Part& part : building.parts) appendMesh(all, meshOf(part));
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
        appendMesh(all.mesh, meshes[i]);
        all.buildingOfTriangle.resize(all.mesh.triangles.size(), Index(i));
    }
    return all;
}

}  // namespace noonmark
