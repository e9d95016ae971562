#include "core/receivers/points/solid_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/city/meshes/mesh_topology.h"

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

namespace {

constexpr double squareM = 32;
long squareOf(double metres) { return long(std::floor(metres / squareM)); }

// The sum over a mesh's faces above a place of 1 for those that face up and -1 for those that face down:
// above 0 inside a closed mesh.
int windingAt(const TriangleMesh& mesh, glm::dvec3 place) {
    int winding = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec2 ab(b - a), ac(c - a), ap(place - a);
        const double turn = ab.x * ac.y - ab.y * ac.x;
        if (std::abs(turn) < 1e-9) continue;
        const double u = (ap.x * ac.y - ap.y * ac.x) / turn, v = (ab.x * ap.y - ab.y * ap.x) / turn;
        if (u < 0 || v < 0 || u + v > 1) continue;
        if (a.z + u * (b.z - a.z) + v * (c.z - a.z) > place.z) winding += turn > 0 ? 1 : -1;
    }
    return winding;
}

}  // namespace

bool isInside(const Part& part, glm::dvec3 place) {
    if (place.z < double(part.bottomM) || place.z >= double(part.topM)) return false;
    // Below an overhanging sheet there is air
    if (part.mesh) return windingAt(*part.mesh, place) > 0 && !(part.isOverhanging && isSheet(*part.mesh));
    return contains(part.footprint, glm::dvec2(place));
}

SolidParts::SolidParts(const City& city) {
    for (std::uint32_t building = 0; building < city.buildings.size(); ++building)
        for (const Part& part : city.buildings[building]->parts) {
            const Box2 box = bounds(part.footprint);
            for (long x = squareOf(double(box.low.x)); x <= squareOf(double(box.high.x)); ++x)
                for (long y = squareOf(double(box.low.y)); y <= squareOf(double(box.high.y)); ++y)
                    squares_[{x, y}].push_back({&part, box, building});
        }
}

std::uint32_t SolidParts::buildingAt(glm::dvec3 place) const {
    const auto found = squares_.find({squareOf(place.x), squareOf(place.y)});
    if (found == squares_.end()) return none;
    for (const Entry& entry : found->second) {
        const Box2& box = entry.box;
        if (place.x >= double(box.low.x) && place.x <= double(box.high.x) && place.y >= double(box.low.y) &&
            place.y <= double(box.high.y) && isInside(*entry.part, place))
            return entry.building;
    }
    return none;
}

}  // namespace noonmark
