#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <unordered_map>

#include "core/base/clean_text.h"
#include "core/study/text/terrain_text.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/checked_row.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

namespace {

template <class T>
std::vector<T> readValues(std::string_view bytes) {
    if (bytes.size() % sizeof(T) != 0) throwDamaged("a list of numbers is cut off");
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

using Meshes = std::unordered_map<std::int64_t, std::shared_ptr<const TriangleMesh>>;

Meshes readMeshes(Database& database) {
    Meshes meshes;
    Statement row = database.prepare("SELECT id, vertices, triangles FROM meshes");
    while (row.step()) {
        auto mesh = std::make_shared<TriangleMesh>();
        mesh->vertices = readValues<glm::vec3>(row.blob(1));
        mesh->triangles = readValues<glm::uvec3>(row.blob(2));
        const CheckedRow checked(row, "meshes");
        if (mesh->triangles.empty()) checked.refuse("the mesh is empty");
        for (const glm::vec3 v : mesh->vertices)
            if (!isWithin(double(v.x), placeLimitsM) || !isWithin(double(v.y), placeLimitsM) ||
                !isWithin(double(v.z), elevationLimitsM))
                checked.refuse("a vertex of the mesh is out of range");
        for (const glm::uvec3 t : mesh->triangles)
            if (std::max({t.x, t.y, t.z}) >= mesh->vertices.size())
                throwDamaged("a mesh triangle names a vertex that does not exist");
        meshes.emplace(row.integer(0), std::move(mesh));
    }
    return meshes;
}

void addParts(const Statement& row, const Meshes& meshes, Building& building) {
    const CheckedRow checked(row, "buildings");
    auto polygons = toPolygons(row.blob(1));
    if (!polygons) checked.refuse("a building has an invalid outline");
    for (Footprint& polygon : *polygons) {
        Part part{.sourceId = cleanText(row.text(3)),
                  .footprint = std::move(polygon),
                  .bottomM = float(checked.number(8, "bottom_m", elevationLimitsM)),
                  .topM = float(checked.number(9, "top_m", elevationLimitsM)),
                  .heightSource = parseHeightSource(row.text(6)).value_or(HeightSource::assumed),
                  .isOverhanging = row.integer(7) != 0};
        if (!(part.topM > part.bottomM)) checked.refuse("a building has no height");
        if (const auto mesh = meshes.find(row.integer(0)); mesh != meshes.end()) part.mesh = mesh->second;
        building.parts.push_back(std::move(part));
    }
}

std::vector<std::shared_ptr<const Building>> readBuildings(Database& database) {
    const Meshes meshes = readMeshes(database);
    std::vector<std::shared_ptr<const Building>> buildings;
    // Rows are in the order of the buildings unless a building was changed later.
    Statement row = database.prepare(
        "SELECT fid, geom, building_id, source_id, name, status, height_source, hangs, bottom_m, top_m, "
        "building "
        "FROM buildings ORDER BY building, fid");
    std::int64_t last = -1;
    Building building;
    const auto finish = [&] {
        if (!building.parts.empty())
            buildings.push_back(std::make_shared<const Building>(std::move(building)));
        building = {};
    };
    while (row.step()) {
        if (row.integer(10) != last) finish();
        last = row.integer(10);
        // Buildings are saved under these numbers.
        if (last != std::int64_t(buildings.size())) throwDamaged("buildings are missing");
        building.sourceId = cleanText(row.text(2));
        building.name = cleanText(row.text(4));
        building.status = cleanText(row.text(5));
        addParts(row, meshes, building);
    }
    finish();
    return buildings;
}

std::shared_ptr<const Terrain> readTerrain(Database& database) {
    Statement row =
        database.prepare("SELECT id, west_m, south_m, cell_m, columns, rows, elevations_m FROM terrain");
    if (!row.step()) return nullptr;
    auto terrain = std::make_shared<Terrain>();
    const CheckedRow checked(row, "terrain");
    terrain->grid = checked.grid(1);
    terrain->elevationM = readValues<float>(row.blob(6));
    if (terrain->elevationM.size() != terrain->grid.size())
        checked.refuse("elevations_m does not have one value per cell");
    for (const float elevation : terrain->elevationM)
        if (!isWithin(double(elevation), elevationLimitsM)) checked.refuse("an elevation is out of range");
    // Older files have no such row; their posts are cell centres.
    if (!takeSource(readFact(database, "terrain_source"), *terrain))
        checked.refuse("the terrain has an invalid position");
    return terrain;
}

double numberOf(Database& database, const std::string& key, const NumberLimits& limits) {
    const std::string text = readFact(database, key);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !isWithin(value, limits))
        throwDamaged(fmt::format("table noonmark, {}: not {:g} to {:g}", key, limits.low, limits.high));
    return value;
}

}  // namespace

std::shared_ptr<const City> readCityTables(Database& database) {
    auto city = std::make_shared<City>();
    const LonLat origin{numberOf(database, "origin_lon_deg", {-360, 360}),
                        numberOf(database, "origin_lat_deg", {-90, 90})};
    city->frame = Frame(origin, numberOf(database, "origin_elevation_m", elevationLimitsM));
    city->buildings = readBuildings(database);
    city->terrain = readTerrain(database);
    city->context = readContext(database);
    return city;
}

}  // namespace noonmark
