#include "core/city/meshes/mesh_sheets.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

namespace {

// Areas of a mesh's faces, square metres.
struct FaceAreas {
    double all = 0;
    double fromAbove = 0;  // in plan, whichever way a face points
    double plumb = 0;      // faces within six degrees of vertical
};

FaceAreas faceAreas(const TriangleMesh& mesh) {
    constexpr double plumbLean = 0.1;
    FaceAreas areas;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]);
        const glm::dvec3 doubled =
            glm::cross(glm::dvec3(mesh.vertices[t.y]) - a, glm::dvec3(mesh.vertices[t.z]) - a);
        const double area = glm::length(doubled) / 2, flat = std::abs(doubled.z) / 2;
        areas.all += area;
        areas.fromAbove += flat;
        if (flat < plumbLean * area) areas.plumb += area;
    }
    return areas;
}

}  // namespace

bool isLevel(const TriangleMesh& mesh) {
    const Box3 box = computeBox(mesh);
    return box.high.z - box.low.z < levelSheetM;
}

bool isUpright(const TriangleMesh& mesh) {
    constexpr double maxLean = 0.0175;
    const FaceAreas areas = faceAreas(mesh);
    return areas.fromAbove <= maxLean * areas.all;
}

bool isSheet(const TriangleMesh& mesh) {
    const FaceAreas areas = faceAreas(mesh);
    return areas.plumb <= 0.01 * areas.all && findOpenEdges(mesh) > 0;
}

double computeAreaFromAbove(const TriangleMesh& mesh) {
    double doubled = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec2 a(mesh.vertices[t.x]);
        const glm::dvec2 b = glm::dvec2(mesh.vertices[t.y]) - a, c = glm::dvec2(mesh.vertices[t.z]) - a;
        doubled += b.x * c.y - b.y * c.x;
    }
    return doubled / 2;
}

}  // namespace noonmark
