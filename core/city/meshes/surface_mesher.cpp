#include "core/city/meshes/surface_mesher.h"

#include <cmath>
#include <glm/geometric.hpp>

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

}  // namespace noonmark
