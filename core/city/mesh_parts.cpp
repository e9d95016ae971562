#include "core/city/mesh_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "core/city/mesh_outline.h"
#include "core/city/mesh_topology.h"

namespace noonmark {

namespace {

constexpr float leastHeightM = 0.01F;

double distanceTo(const Ring& ring, glm::dvec2 point) {
    double least = 1e30;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a(ring[i]);
        const glm::dvec2 along = glm::dvec2(ring[(i + 1) % ring.size()]) - a;
        const double share =
            std::clamp(glm::dot(point - a, along) / std::max(1e-12, glm::dot(along, along)), 0.0, 1.0);
        least = std::min(least, glm::distance(point, a + share * along));
    }
    return least;
}

double distanceTo(const Footprint& footprint, glm::dvec2 point) {
    return contains(footprint, point) ? 0 : distanceTo(footprint.outer, point);
}

// A point from above that is surely of this mesh's own outline: the middle of its widest triangle.
glm::dvec2 widestMiddle(const TriangleMesh& mesh) {
    double widest = -1;
    glm::dvec2 middle{};
    for (const glm::uvec3 t : mesh.triangles) {
        const Ring ring{glm::vec2(mesh.vertices[t.x]), glm::vec2(mesh.vertices[t.y]),
                        glm::vec2(mesh.vertices[t.z])};
        const double area = std::abs(signedArea(ring));
        if (area <= widest) continue;
        widest = area;
        middle = (glm::dvec2(ring[0]) + glm::dvec2(ring[1]) + glm::dvec2(ring[2])) / 3.0;
    }
    return middle;
}

std::size_t nearestPiece(const std::vector<Footprint>& pieces, glm::dvec2 point) {
    const auto nearer = [&](const Footprint& a, const Footprint& b) {
        return distanceTo(a, point) < distanceTo(b, point);
    };
    return std::size_t(std::min_element(pieces.begin(), pieces.end(), nearer) - pieces.begin());
}

// One mesh per piece of the outline: what hangs together lies in one piece, since its outline does too.
std::vector<TriangleMesh> splitByPiece(TriangleMesh mesh, const std::vector<Footprint>& pieces) {
    if (pieces.size() == 1) return {std::move(mesh)};
    std::vector<TriangleMesh> meshes(pieces.size());
    for (const TriangleMesh& component : separated(mesh, componentsOf(mesh)))
        append(meshes[nearestPiece(pieces, widestMiddle(component))], component);
    return meshes;
}

Part partOf(TriangleMesh mesh, Footprint footprint, const std::string& sourceId) {
    const Box3 box = boxOf(mesh);
    Part part{
        .sourceId = sourceId, .footprint = std::move(footprint), .bottomM = box.low.z, .topM = box.high.z};
    part.heightSource = HeightSource::mesh;
    part.hangs = hasOpenAirBelow(mesh);
    part.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    return part;
}

bool hasHeight(const TriangleMesh& mesh) {
    const Box3 box = boxOf(mesh);
    return box.high.z - box.low.z >= leastHeightM;
}

// What of its faces look down clear of the bottom, m2 from above.
double areaLookingDownAbove(const TriangleMesh& mesh, float bottomM) {
    double area = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec3 doubled = glm::cross(b - a, c - a);
        const double lean = -doubled.z / std::max(1e-12, glm::length(doubled));  // 1: looks straight down
        if (lean < 0.1) continue;
        const double height = lean > 0.7 ? std::min({a.z, b.z, c.z}) : (a.z + b.z + c.z) / 3;
        if (height > double(bottomM) + double(openAirM)) area -= doubled.z / 2;
    }
    return area;
}

bool isCavity(const TriangleMesh& component, const Box3& whole) {
    return signedVolume(component) < 0 && boxOf(component).liesInside(whole);
}

}  // namespace

bool hasOpenAirBelow(const TriangleMesh& mesh) {
    constexpr double leastAreaM2 = 0.1;
    const Box3 whole = boxOf(mesh);
    if (areaLookingDownAbove(mesh, whole.low.z) <= leastAreaM2) return false;
    double area = 0;
    for (const TriangleMesh& component : separated(mesh, componentsOf(mesh)))
        if (!isCavity(component, whole)) area += areaLookingDownAbove(component, whole.low.z);
    return area > leastAreaM2;
}

MeshParts partsOf(const TriangleMesh& raw, const std::string& sourceId, const std::string& where) {
    MeshParts result;
    const auto warn = [&](WarningKind kind, const char* what) {
        result.warnings.push_back({kind, what, where});
    };
    TriangleMesh mesh = welded(raw);
    const bool closed = openEdges(mesh) == 0;
    removeDegenerateTriangles(mesh);
    const std::size_t dropped = raw.triangles.size() - mesh.triangles.size();
    if (dropped > 0)
        result.warnings.push_back({WarningKind::mended, "faces without area were left out",
                                   fmt::format("{} ({})", where, dropped)});
    if (mesh.triangles.empty() || !hasHeight(mesh)) {
        warn(WarningKind::dropped, "has no height, so it casts no shadow");
        return result;
    }
    if (!closed) warn(WarningKind::mended, "its surface is not closed; used as it is");
    if (turnOutward(mesh) > 0) warn(WarningKind::mended, "its faces looked inward and were turned");
    MeshOutline outline = outlineOf(mesh, closed);
    if (outline.pieces.empty()) warn(WarningKind::dropped, "a sheet on edge: it covers no ground");
    if (outline.pieces.empty()) return result;
    if (outline.convexHull)
        warn(WarningKind::mended, "its outline could not be found; the convex hull stands in");
    std::vector<TriangleMesh> meshes = splitByPiece(std::move(mesh), outline.pieces);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        if (meshes[i].triangles.empty() || !hasHeight(meshes[i]))
            warn(WarningKind::leftOut, "a piece of it is flat, so it casts no shadow");
        else
            result.parts.push_back(partOf(std::move(meshes[i]), std::move(outline.pieces[i]), sourceId));
    }
    return result;
}

void markHanging(std::vector<Part>& parts, const std::function<float(glm::dvec2)>& groundM) {
    constexpr float reachM = 0.5F;  // a lower part that ends this near below still carries
    std::vector<Part*> upward;
    for (Part& part : parts) upward.push_back(&part);
    std::stable_sort(upward.begin(), upward.end(),
                     [](const Part* a, const Part* b) { return a->bottomM < b->bottomM; });
    std::vector<const Part*> standing;
    for (Part* part : upward) {
        const Box2 box = bounds(part->footprint);
        if (part->bottomM > groundM((glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0) + openAirM) {
            std::vector<Footprint> carrying;
            for (const Part* lower : standing)
                if (lower->topM >= part->bottomM - reachM) carrying.push_back(lower->footprint);
            const double open = areaOutside(part->footprint, carrying);
            if (open > std::max(0.5, 0.05 * area(part->footprint))) part->hangs = true;
        }
        if (!part->hangs) standing.push_back(part);
    }
}

}  // namespace noonmark
