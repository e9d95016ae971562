#include "core/city/meshes/mesh_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "core/base/stop_scope.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

// Marked outside of the class: lupdate takes its name for the context of what is marked in it.
constexpr const char* withoutAreaText = NM_TEXT("has no area, so it casts no shadow");
constexpr const char* facesWithoutAreaText = NM_TEXT("faces without area were left out");
constexpr const char* notClosedText = NM_TEXT("its surface is not closed; it is used unchanged");
constexpr const char* turnedText = NM_TEXT("its faces pointed inward and were turned");
constexpr const char* withoutOutlineText = NM_TEXT("its outline could not be determined");

double distanceToArea(const Footprint& footprint, glm::dvec2 point) {
    return contains(footprint, point) ? 0 : distanceTo(footprint.outer, point);
}

// A point in plan that certainly lies in this mesh's own outline: the centre of its largest triangle.
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
        return distanceToArea(a, point) < distanceToArea(b, point);
    };
    return std::size_t(std::min_element(pieces.begin(), pieces.end(), nearer) - pieces.begin());
}

// One mesh per piece of the outline: a connected component lies in one piece, since its outline is connected
// too.
std::vector<TriangleMesh> splitByPiece(TriangleMesh mesh, const std::vector<Footprint>& pieces) {
    if (pieces.size() == 1) return {std::move(mesh)};
    std::vector<TriangleMesh> meshes(pieces.size());
    for (const TriangleMesh& component : separateComponents(mesh, findComponents(mesh)))
        append(meshes[nearestPiece(pieces, widestMiddle(component))], component);
    return meshes;
}

Part cutInterval(TriangleMesh mesh, Footprint footprint, const std::string& sourceId) {
    const MeshBox box = computeBox(mesh);
    Part part{
        .sourceId = sourceId, .footprint = std::move(footprint), .bottomM = box.low.z, .topM = box.high.z};
    part.heightSource = HeightSource::mesh;
    part.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    return part;
}

// A level sheet becomes a prism whose top is the sheet's true height.
Part slabOf(const TriangleMesh& sheet, Footprint footprint, const std::string& sourceId) {
    const float topM = computeBox(sheet).high.z;
    return {.sourceId = sourceId,
            .footprint = std::move(footprint),
            .bottomM = topM - levelSheetM,
            .topM = topM,
            .heightSource = HeightSource::mesh};
}

// Area of the downward faces above the mesh's bottom, m2 in plan.
double areaLookingDownAbove(const TriangleMesh& mesh, float bottomM) {
    double area = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec3 doubled = glm::cross(b - a, c - a);
        const double lean = -doubled.z / std::max(1e-12, glm::length(doubled));  // 1: faces straight down
        if (lean < 0.1) continue;
        const double height = lean > 0.7 ? std::min({a.z, b.z, c.z}) : (a.z + b.z + c.z) / 3;
        if (height > double(bottomM) + double(openAirM)) area -= doubled.z / 2;
    }
    return area;
}

bool isCavity(const TriangleMesh& component, const MeshBox& whole) {
    return signedVolume(component) < 0 && computeBox(component).liesInside(whole);
}

// Area of a sheet's faces above the bottom, m2 in plan, whichever way they face.
double areaAbove(const TriangleMesh& sheet, float bottomM) {
    double area = 0;
    for (const glm::uvec3 t : sheet.triangles) {
        const glm::vec3 a = sheet.vertices[t.x], b = sheet.vertices[t.y], c = sheet.vertices[t.z];
        if ((a.z + b.z + c.z) / 3 > bottomM + openAirM)
            area += std::abs(signedArea({glm::vec2(a), glm::vec2(b), glm::vec2(c)}));
    }
    return area;
}

bool isCarriedByWalls(const TriangleMesh& sheet, const TriangleMesh& whole) {
    const auto isWalled = [&](const Footprint& piece) {
        return computeWalledShare(whole, piece, openAirM) >= walledEnough;
    };
    return std::ranges::all_of(computeOutline(sheet, false).pieces, isWalled);
}

// Area with open air below of one component, m2 in plan.
double openArea(const TriangleMesh& component, const TriangleMesh& whole, const MeshBox& box) {
    if (isCavity(component, box)) return 0;
    if (!isSheet(component)) return areaLookingDownAbove(component, box.low.z);
    const double area = areaAbove(component, box.low.z);
    return area > 0 && !isCarriedByWalls(component, whole) ? area : 0;
}

}  // namespace

bool hasOpenAirBelow(const TriangleMesh& mesh) {
    constexpr double minAreaM2 = 0.1;
    const MeshBox whole = computeBox(mesh);
    if (findOpenEdges(mesh) == 0 && areaLookingDownAbove(mesh, whole.low.z) <= minAreaM2) return false;
    double area = 0;
    for (const TriangleMesh& component : separateComponents(mesh, findComponents(mesh)))
        area += openArea(component, mesh, whole);
    return area > minAreaM2;
}

namespace {

// Makes the parts of one mesh and records the repairs.
class PartsMaker {
public:
    PartsMaker(const std::string& sourceId, const std::string& where) : sourceId_(sourceId), where_(where) {}

    MeshParts make(const TriangleMesh& raw) {
        TriangleMesh mesh = cleaned(raw);
        if (StopScope::isStopped()) return std::move(made_);
        if (mesh.triangles.empty()) {
            warn(WarningKind::dropped, withoutAreaText);
            return std::move(made_);
        }
        if (isLevel(mesh))
            addSlabs(mesh);
        else
            addSolids(std::move(mesh));
        return std::move(made_);
    }

private:
    void warn(WarningKind kind, const char* what) { made_.warnings.push_back({kind, what, where_}); }

    TriangleMesh cleaned(const TriangleMesh& raw) {
        TriangleMesh mesh = weld(raw);
        closed_ = findOpenEdges(mesh) == 0;  // faces without area can close it too
        removeDegenerateTriangles(mesh);
        const std::size_t dropped = raw.triangles.size() - mesh.triangles.size();
        if (dropped > 0)
            made_.warnings.push_back(
                {WarningKind::repaired, facesWithoutAreaText, fmt::format("{} ({})", where_, dropped)});
        return mesh;
    }

    void addSlabs(const TriangleMesh& sheet) {
        for (Footprint& piece : computeOutline(sheet, false).pieces)
            made_.parts.push_back(slabOf(sheet, std::move(piece), sourceId_));
    }

    void addSolids(TriangleMesh mesh) {
        if (!closed_ && !isSheet(mesh) && !isUpright(mesh)) warn(WarningKind::repaired, notClosedText);
        if (turnOutward(mesh) > 0) warn(WarningKind::repaired, turnedText);
        MeshOutline outline = computeOutline(mesh, closed_);
        if (StopScope::isStopped()) return;
        if (outline.pieces.empty()) return warn(WarningKind::dropped, withoutOutlineText);
        if (outline.wallsOnly && area(outline.pieces.front()) > 1)
            warn(WarningKind::assumed, "walls without a roof; the ground that they enclose counts as inside");
        const float lowM = computeBox(mesh).low.z;
        std::vector<TriangleMesh> meshes = splitByPiece(std::move(mesh), outline.pieces);
        for (std::size_t i = 0; i < meshes.size(); ++i)
            addPiece(std::move(meshes[i]), std::move(outline.pieces[i]), lowM);
    }

    void addPiece(TriangleMesh mesh, Footprint footprint, float lowM) {
        if (mesh.triangles.empty()) return;
        if (!isLevel(mesh))
            addUneven(std::move(mesh), std::move(footprint));
        else if (computeBox(mesh).high.z > lowM + levelSheetM)
            made_.parts.push_back(slabOf(mesh, std::move(footprint), sourceId_));
        else
            warn(WarningKind::leftOut, "a level piece at its foot was taken as ground");
    }

    // Eaves let the sun in below them; the building that they belong to does not.
    void addUneven(TriangleMesh mesh, Footprint footprint) {
        const bool isOverhanging = hasOpenAirBelow(mesh);
        auto cut = closed_ || isOverhanging ? std::nullopt : cutEaves(mesh);
        if (!cut) return addInterval(std::move(mesh), std::move(footprint), isOverhanging);
        addPieces(std::move(cut->body), false);
        addPieces(std::move(cut->eaves), true);
    }

    void addPieces(TriangleMesh mesh, bool isOverhanging) {
        std::vector<Footprint> pieces = computeOutline(mesh, false).pieces;
        if (pieces.empty()) return warn(WarningKind::dropped, withoutOutlineText);
        std::vector<TriangleMesh> meshes = splitByPiece(std::move(mesh), pieces);
        for (std::size_t i = 0; i < meshes.size(); ++i)
            if (!meshes[i].triangles.empty())
                addInterval(std::move(meshes[i]), std::move(pieces[i]), isOverhanging);
    }

    void addInterval(TriangleMesh mesh, Footprint footprint, bool isOverhanging) {
        if (isLevel(mesh))
            made_.parts.push_back(slabOf(mesh, std::move(footprint), sourceId_));
        else
            made_.parts.push_back(cutInterval(std::move(mesh), std::move(footprint), sourceId_));
        made_.parts.back().isOverhanging = isOverhanging;
    }

    const std::string& sourceId_;
    const std::string& where_;
    MeshParts made_;
    bool closed_ = false;
};

}  // namespace

MeshParts partsOf(const TriangleMesh& raw, const std::string& sourceId, const std::string& where) {
    return PartsMaker(sourceId, where).make(raw);
}

void markOverhangs(std::vector<Part>& parts, const std::function<float(glm::dvec2)>& groundM) {
    constexpr float reachM = 0.5F;  // a lower part whose top is at most this far below still carries
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
            const double open = computeAreaOutside(part->footprint, carrying);
            // A wall above the ground may have only a few square centimetres
            const double all = area(part->footprint);
            if (open > std::max(std::min(0.5, all / 2), 0.05 * all)) part->isOverhanging = true;
        }
        if (!part->isOverhanging) standing.push_back(part);
    }
}

}  // namespace noonmark
