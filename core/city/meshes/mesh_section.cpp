#include "core/city/meshes/mesh_section.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

namespace {

// Interpolated from the edge's lower end, so that both triangles of an edge give the same point.
glm::dvec2 cutOf(glm::dvec3 below, glm::dvec3 above, double heightM) {
    const double share = (heightM - below.z) / (above.z - below.z);
    return glm::dvec2(below) + share * (glm::dvec2(above) - glm::dvec2(below));
}

// The direction of the line puts the inside of a closed mesh on its left.
std::optional<PlanLine> cutThrough(const TriangleMesh& mesh, glm::uvec3 triangle, double heightM) {
    glm::dvec3 p[3];
    int above = 0;
    for (int i = 0; i < 3; ++i) {
        p[i] = glm::dvec3(mesh.vertices[triangle[i]]);
        above += p[i].z >= heightM ? 1 : 0;
    }
    if (above == 0 || above == 3) return std::nullopt;
    const bool oneAbove = above == 1;
    int apart = 0;  // the corner that is alone on its side of the section
    while ((p[apart].z >= heightM) != oneAbove) ++apart;
    const glm::dvec3 &alone = p[apart], &next = p[(apart + 1) % 3], &last = p[(apart + 2) % 3];
    const glm::dvec2 toNext = oneAbove ? cutOf(next, alone, heightM) : cutOf(alone, next, heightM);
    const glm::dvec2 toLast = oneAbove ? cutOf(last, alone, heightM) : cutOf(alone, last, heightM);
    if (toNext == toLast) return std::nullopt;
    return oneAbove ? PlanLine{toNext, toLast} : PlanLine{toLast, toNext};
}

std::vector<PlanLine> cutLines(const TriangleMesh& mesh, double heightM) {
    std::vector<PlanLine> lines;
    for (const glm::uvec3 triangle : mesh.triangles)
        if (const auto line = cutThrough(mesh, triangle, heightM)) lines.push_back(*line);
    return lines;
}

// Winding number of lines around a point, counter-clockwise.
int windingAround(glm::dvec2 point, const std::vector<PlanLine>& lines) {
    int winding = 0;
    for (const auto& [a, b] : lines) {
        if ((a.y <= point.y) == (b.y <= point.y)) continue;
        const double x = a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x);
        if (x > point.x) winding += b.y > a.y ? 1 : -1;
    }
    return winding;
}

std::vector<Footprint> insideOf(const std::vector<PlanLine>& lines) {
    std::vector<Footprint> inside;
    for (Footprint& face : findFaces(lines))
        if (windingAround(findPointInside(face), lines) > 0) inside.push_back(std::move(face));
    return inside;
}

// The faces of a mesh that reach above a height, in plan.
std::vector<Footprint> coverAbove(const TriangleMesh& mesh, double heightM) {
    TriangleMesh upper{mesh.vertices, {}};
    for (const glm::uvec3 t : mesh.triangles)
        if (double(mesh.vertices[t.x].z + mesh.vertices[t.y].z + mesh.vertices[t.z].z) / 3 > heightM)
            upper.triangles.push_back(t);
    MeshOutline outline = computeOutline(upper, false);
    return outline.wallsOnly ? std::vector<Footprint>{} : std::move(outline.pieces);
}

}  // namespace

MeshSection cutSection(const TriangleMesh& mesh, double heightM) {
    const std::vector<PlanLine> lines = cutLines(mesh, heightM);
    if (findOpenEdges(mesh) == 0) return {insideOf(lines), false};
    if (std::vector<Footprint> enclosed = findEnclosedFaces(lines); !enclosed.empty())
        return {std::move(enclosed), false};
    if (std::vector<Footprint> enclosed = findEnclosedFaces(closeChains(lines)); !enclosed.empty())
        return {std::move(enclosed), true};
    return {coverAbove(mesh, heightM), true};
}

namespace {

constexpr int maxFloors = 1000;
constexpr double sameLevelM = 0.01;

void addRing(const Ring& ring, double z, std::vector<std::vector<glm::vec3>>& lines) {
    std::vector<glm::vec3>& line = lines.emplace_back();
    for (const glm::vec2 point : ring) line.emplace_back(point, float(z));
}

void addOutline(const Footprint& outline, double z, std::vector<std::vector<glm::vec3>>& lines) {
    addRing(outline.outer, z, lines);
    for (const Ring& hole : outline.holes) addRing(hole, z, lines);
}

void addFloor(const Part& part, double z, std::vector<std::vector<glm::vec3>>& lines) {
    if (!part.mesh) return addOutline(part.footprint, z, lines);
    for (const Footprint& piece : cutSection(*part.mesh, z).pieces) addOutline(piece, z, lines);
}

}  // namespace

std::vector<std::vector<glm::vec3>> makeStoreyLines(const Building& building, double groundM,
                                                    double storeyHeightM) {
    std::vector<std::vector<glm::vec3>> lines;
    const double topM = double(noonmark::topM(building));
    for (int floor = 1; floor <= maxFloors; ++floor) {
        const double z = groundM + floor * storeyHeightM;
        if (z > topM - sameLevelM) break;
        for (const Part& part : building.parts)
            if (double(part.bottomM) <= z - sameLevelM && z + sameLevelM <= double(part.topM))
                addFloor(part, z, lines);
    }
    return lines;
}

}  // namespace noonmark
