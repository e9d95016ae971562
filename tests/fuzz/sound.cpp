#include "tests/fuzz/sound.h"

#include <algorithm>
#include <cmath>

#include "core/io/terrain/buildings_on_terrain.h"
#include "tests/fuzz/require.h"

namespace noonmark::tests {

namespace {

void requireShape(const Ring& ring) {
    require(ring.size() >= 3, "a ring has three points or more");
    for (const glm::vec2 point : ring)
        require(std::isfinite(point.x) && std::isfinite(point.y), "points of a ring are finite");
}

void requireShape(const Footprint& footprint) {
    requireShape(footprint.outer);
    for (const Ring& hole : footprint.holes) requireShape(hole);
}

void requireShape(const TriangleMesh& mesh) {
    for (const glm::vec3 point : mesh.vertices)
        require(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z),
                "vertices of a mesh are finite");
    for (const glm::uvec3 corners : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            require(corners[i] < mesh.vertices.size(), "corners of a triangle are there");
}

void requireShape(const Part& part) {
    requireShape(part.footprint);
    require(std::isfinite(part.bottomM) && std::isfinite(part.topM), "heights are finite");
    require(part.topM > part.bottomM, "a part has a height");
    if (part.mesh) requireShape(*part.mesh);
}

std::vector<BasedBuilding> basedBuildings(const FilePiece& piece) {
    std::vector<BasedBuilding> based;
    for (std::size_t i = 0; i < piece.groundM.size(); ++i)
        if (piece.groundM[i]) based.push_back({piece.buildings[i].get(), *piece.groundM[i]});
    return based;
}

}  // namespace

void requireSound(const Building& building) {
    require(!building.parts.empty(), "a building has parts");
    for (const Part& part : building.parts) requireShape(part);
}

void requireSound(const Terrain& terrain) {
    require(terrain.elevationM.size() == terrain.grid.size(), "every post has an elevation");
    require(std::ranges::all_of(terrain.elevationM, [](float z) { return std::isfinite(z); }),
            "elevations are finite");
    require(std::isfinite(elevationAt(terrain, {0, 0})), "the ground has an elevation everywhere");
}

void requireSound(const City& city) {
    for (const auto& building : city.buildings) requireSound(*building);
    if (city.terrain) requireSound(*city.terrain);
}

void requireSound(const FilePiece& piece) {
    for (const auto& building : piece.buildings) requireSound(*building);
    require(piece.groundM.empty() || piece.groundM.size() == piece.buildings.size(),
            "every building has its ground");
    if (piece.terrain) requireSound(*piece.terrain);
    require(!piece.format.empty(), "the format has a name");
}

void requireSound(const std::vector<Footprint>& polygons) {
    for (const Footprint& polygon : polygons) requireShape(polygon);
}

void requireSound(const MapContext& context) {
    const auto isFinite = [](glm::vec2 point) { return std::isfinite(point.x) && std::isfinite(point.y); };
    for (const ContextArea& area : context.areas) requireSound(area.polygons);
    for (const ContextLine& line : context.lines) {
        require(line.points.size() >= 2 && std::ranges::all_of(line.points, isFinite), "a line has points");
        require(std::isfinite(line.widthM) && line.widthM >= 0, "a line has a width");
    }
    require(std::ranges::all_of(context.trees, isFinite), "trees are somewhere");
}

void requireSound(const Error& error) {
    require(!error.what.empty(), "an error says what is wrong");
    require(!isCancelled(error), "only a stop cancels");
}

// As in readCity().
static void standOnBases(const FilePiece& piece) {
    const std::vector<BasedBuilding> based = basedBuildings(piece);
    (void)formatText(measureRelief(based));
    const auto terrain = interpolateBases(based);
    if (!terrain) return;
    requireSound(*terrain);
    for (std::size_t i = 0; i < piece.groundM.size(); ++i)
        requireSound(standOnTerrain(*piece.buildings[i], piece.groundM[i], &*terrain));
}

void use(const Result<FilePiece>& piece) {
    if (!piece) return requireSound(piece.error());
    requireSound(*piece);
    standOnBases(*piece);
}

}  // namespace noonmark::tests
