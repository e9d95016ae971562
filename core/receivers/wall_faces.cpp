#include "core/receivers/wall_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

namespace noonmark {

namespace {

void addWalls(const Ring& ring, const Part& part, std::vector<WallFace>& faces) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a(ring[i]), b(ring[(i + 1) % ring.size()]);
        const double length = glm::length(b - a);
        if (length < 0.01) continue;
        faces.push_back({a, (b - a) / length, length, double(part.bottomM), double(part.topM), {}});
    }
}

/// A triangle of an upright face in space.
struct UprightTriangle {
    std::array<glm::dvec3, 3> corners;
    glm::dvec2 normal;
};

std::vector<UprightTriangle> uprightTriangles(const TriangleMesh& mesh) {
    constexpr double steepest = 0.1045;  // sine of 6 degrees
    std::vector<UprightTriangle> upright;
    for (const glm::uvec3 t : mesh.triangles) {
        const std::array corners{glm::dvec3(mesh.vertices[t.x]), glm::dvec3(mesh.vertices[t.y]),
                                 glm::dvec3(mesh.vertices[t.z])};
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double size = glm::length(normal);
        if (size < 1e-6 || std::abs(normal.z) > steepest * size) continue;
        upright.push_back({corners, glm::normalize(glm::dvec2(normal))});
    }
    return upright;
}

std::pair<long, long> planeOf(const UprightTriangle& triangle) {
    const double azimuth = std::atan2(triangle.normal.x, triangle.normal.y) * 180 / std::numbers::pi;
    const glm::dvec2 middle = (glm::dvec2(triangle.corners[0]) + glm::dvec2(triangle.corners[1]) +
                               glm::dvec2(triangle.corners[2])) /
                              3.0;
    return {std::lround(azimuth + 360) % 360, std::lround(glm::dot(triangle.normal, middle) / 0.05)};
}

WallFace joinFace(const std::vector<const UprightTriangle*>& triangles) {
    WallFace face;
    face.along = {-triangles.front()->normal.y, triangles.front()->normal.x};
    const glm::dvec2 origin(triangles.front()->corners[0]);
    double first = 1e30, last = -1e30;
    face.lowM = 1e30, face.highM = -1e30;
    for (const UprightTriangle* triangle : triangles)
        for (const glm::dvec3 corner : triangle->corners) {
            const double along = glm::dot(glm::dvec2(corner) - origin, face.along);
            first = std::min(first, along), last = std::max(last, along);
            face.lowM = std::min(face.lowM, corner.z), face.highM = std::max(face.highM, corner.z);
        }
    face.start = origin + first * face.along;
    face.lengthM = last - first;
    for (const UprightTriangle* triangle : triangles) {
        std::array<glm::dvec2, 3> flat;
        for (std::size_t i = 0; i < 3; ++i)
            flat[i] = {glm::dot(glm::dvec2(triangle->corners[i]) - face.start, face.along),
                       triangle->corners[i].z};
        face.triangles.push_back(flat);
    }
    return face;
}

}  // namespace

bool WallFace::covers(glm::dvec2 place) const {
    if (place.x < 0 || place.x > lengthM || place.y < lowM || place.y > highM) return false;
    const auto turn = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    return triangles.empty() || std::ranges::any_of(triangles, [&](const std::array<glm::dvec2, 3>& t) {
               const double one = turn(t[0], t[1], place), two = turn(t[1], t[2], place),
                            three = turn(t[2], t[0], place);
               return (one >= 0 && two >= 0 && three >= 0) || (one <= 0 && two <= 0 && three <= 0);
           });
}

std::vector<WallFace> findWallFaces(const Part& part) {
    std::vector<WallFace> faces;
    if (!part.mesh) {
        addWalls(part.footprint.outer, part, faces);
        for (const Ring& hole : part.footprint.holes) addWalls(hole, part, faces);
        return faces;
    }
    const std::vector<UprightTriangle> upright = uprightTriangles(*part.mesh);
    std::map<std::pair<long, long>, std::vector<const UprightTriangle*>> planes;
    for (const UprightTriangle& triangle : upright) planes[planeOf(triangle)].push_back(&triangle);
    for (const auto& [plane, triangles] : planes) faces.push_back(joinFace(triangles));
    return faces;
}

}  // namespace noonmark
