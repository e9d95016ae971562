#include <fmt/format.h>

#include "core/city/terrain/building_ground.h"
#include "core/study/text/terrain_text.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/tables/grid_tiles.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

namespace {

template <class T>
Bytes bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

class BuildingWriter {
public:
    BuildingWriter(Database& database, const City& city)
        : database_(database),
          city_(city),
          add_(database.prepare(
              "INSERT INTO buildings (geom, building_id, source_id, name, status, height, min_height, "
              "ground_elevation, height_source, hangs, bottom_m, top_m, building) "
              "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")),
          addMesh_(database.prepare("INSERT INTO meshes (id, vertices, triangles) VALUES (?, ?, ?)")),
          remove_(database.prepare("DELETE FROM buildings WHERE building = ?")),
          removeMeshes_(database.prepare(
              "DELETE FROM meshes WHERE id IN (SELECT fid FROM buildings WHERE building = ?)")) {}

    void remove(std::size_t index) {
        removeMeshes_.run(index);
        remove_.run(index);
    }

    void add(std::size_t index) {
        const Building& building = *city_.buildings[index];
        const float ground = findGroundUnder(building, city_);
        for (const Part& part : building.parts) add(index, building, part, ground);
    }

private:
    void add(std::size_t index, const Building& building, const Part& part, float ground) {
        // In a flat city at 0 the elevation is unknown.
        const double elevation = city_.frame.originElevationM() + double(ground);
        std::optional<double> stated;
        if (city_.terrain || elevation != 0) stated.emplace(elevation);
        add_.run(AsBlob{polygonBlob(part.footprint)}, building.sourceId, part.sourceId, building.name,
                 building.status, part.topM - ground, part.bottomM - ground, stated,
                 nameOf(part.heightSource), part.isOverhanging, part.bottomM, part.topM, index);
        if (!part.mesh) return;
        const Bytes vertices = bytesOf(part.mesh->vertices), triangles = bytesOf(part.mesh->triangles);
        addMesh_.run(database_.lastRow(), AsBlob{vertices}, AsBlob{triangles});
    }

    Database& database_;
    const City& city_;
    Statement add_, addMesh_, remove_, removeMeshes_;
};

void writeTerrain(Database& database, const Terrain* terrain) {
    database.execute("DELETE FROM terrain");
    setFact(database, "terrain_source", terrain == nullptr ? std::string() : sourceText(*terrain));
    if (terrain == nullptr) return;
    const PostGrid& grid = terrain->grid;
    const glm::dvec2 corner = grid.first - (grid.columnStep + grid.rowStep) / 2.0;
    const Bytes elevations = bytesOf(terrain->elevationM);
    database
        .prepare(
            "INSERT INTO terrain (west_m, south_m, cell_m, columns, rows, elevations_m) VALUES (?, ?, ?, ?, "
            "?, ?)")
        .run(corner.x, corner.y, grid.cellM, grid.columns, grid.rows, AsBlob{elevations});
}

void writeFrame(Database& database, const Frame& frame) {
    setFact(database, "origin_lon_deg", fmt::format("{:.17g}", frame.origin().lonDeg));
    setFact(database, "origin_lat_deg", fmt::format("{:.17g}", frame.origin().latDeg));
    setFact(database, "origin_elevation_m", fmt::format("{:.17g}", frame.originElevationM()));
    database.prepare("UPDATE gpkg_spatial_ref_sys SET definition = ? WHERE srs_id = ?")
        .run(localCrsWkt(frame), localSrsId);
}

}  // namespace

void writeCity(Database& database, const City* before, const City& after) {
    static const City none;
    const City& old = before != nullptr ? *before : none;
    if (before == nullptr || old.frame != after.frame) writeFrame(database, after.frame);
    if (before == nullptr || old.terrain != after.terrain) writeTerrain(database, after.terrain.get());
    if (before == nullptr || old.context != after.context) writeContext(database, after.context.get());
    BuildingWriter writer(database, after);
    const std::size_t most = std::max(old.buildings.size(), after.buildings.size());
    for (std::size_t i = 0; i < most; ++i) {
        const bool was = i < old.buildings.size(), is = i < after.buildings.size();
        if (was && is && old.buildings[i] == after.buildings[i]) continue;
        if (was) writer.remove(i);
        if (is) writer.add(i);
    }
    const Box2 box = bounds(after);
    touchLayer(database, "buildings", double(box.low.x), double(box.low.y), double(box.high.x),
               double(box.high.y));
    setFact(database, "buildings", std::to_string(after.buildings.size()));
}

}  // namespace noonmark
