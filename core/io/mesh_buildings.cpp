#include "core/io/mesh_buildings.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "core/city/mesh_outline.h"
#include "core/city/mesh_parts.h"
#include "core/city/mesh_topology.h"

namespace noonmark {

namespace {

constexpr float flatM = 0.01F;

bool isGround(const TriangleMesh& component, float lowest) {
    const Box3 box = boxOf(component);
    return box.high.z - box.low.z < flatM && box.low.z < lowest + flatM;
}

// Takes the flat pieces at the bottom away, unless there is nothing else. Says how many.
std::size_t removeGround(std::vector<TriangleMesh>& components, float lowest) {
    const auto ground = [&](const TriangleMesh& component) { return isGround(component, lowest); };
    if (std::all_of(components.begin(), components.end(), ground)) return 0;
    return std::erase_if(components, ground);
}

// Components that stand over one another, joined.
std::vector<TriangleMesh> buildingMeshes(const std::vector<TriangleMesh>& components) {
    std::vector<std::vector<Footprint>> outlines;
    for (const TriangleMesh& component : components)
        outlines.push_back(outlineOf(component, openEdges(component) == 0).pieces);
    std::vector<TriangleMesh> meshes;
    const std::vector<std::size_t> groups = overlapGroups(outlines);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i] == meshes.size()) meshes.emplace_back();
        append(meshes[groups[i]], components[i]);
    }
    return meshes;
}

void addBuilding(const TriangleMesh& mesh, const std::string& name, const std::string& id,
                 const std::string& file, FilePiece& piece) {
    MeshParts made = partsOf(mesh, id, file + ": " + id);
    std::move(made.warnings.begin(), made.warnings.end(), std::back_inserter(piece.warnings));
    if (made.parts.empty()) return;
    markHanging(made.parts, [](glm::dvec2) { return 0.0F; });
    piece.buildings.push_back(
        std::make_shared<const Building>(Building{id, name, {}, std::move(made.parts)}));
}

void addObject(const NamedMesh& object, const std::string& file, FilePiece& piece,
               const std::stop_token& stop) {
    const TriangleMesh mesh = welded(object.mesh);
    std::vector<TriangleMesh> components = separated(mesh, componentsOf(mesh));
    if (const std::size_t flat = removeGround(components, boxOf(mesh).low.z); flat > 0)
        piece.warnings.push_back(
            {WarningKind::leftOut, "flat ground", fmt::format("{}: {} ({})", file, object.name, flat)});
    const std::size_t dropped = object.mesh.triangles.size() - mesh.triangles.size();
    if (dropped > 0)
        piece.warnings.push_back({WarningKind::mended, "faces without area were left out",
                                  fmt::format("{}: {} ({})", file, object.name, dropped)});
    const std::vector<TriangleMesh> meshes = buildingMeshes(components);
    const std::string id = object.name.empty() ? "mesh" : object.name;
    for (std::size_t i = 0; i < meshes.size() && !stop.stop_requested(); ++i)
        addBuilding(meshes[i], object.name, meshes.size() == 1 ? id : fmt::format("{} {}", id, i + 1), file,
                    piece);
}

// Meshes in elevations above the sea look so; their shadows would start in the air.
void warnIfAloft(const std::string& file, FilePiece& piece) {
    float lowest = 1e30F;
    for (const auto& building : piece.buildings)
        for (const Part& part : building->parts) lowest = std::min(lowest, part.bottomM);
    if (piece.buildings.empty() || lowest <= openAirM) return;
    piece.warnings.push_back({WarningKind::assumed,
                              "all of it is above the ground, which is at the mesh's zero height",
                              fmt::format("{} ({:.1f} m)", file, lowest)});
}

}  // namespace

bool addBuildings(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece,
                  Progress& progress, const std::stop_token& stop) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (stop.stop_requested()) return false;
        progress.report(double(i) / double(objects.size()), "finding the buildings");
        addObject(objects[i], file, piece, stop);
    }
    warnIfAloft(file, piece);
    return !stop.stop_requested();
}

}  // namespace noonmark
