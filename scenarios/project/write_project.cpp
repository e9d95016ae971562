#include "scenarios/project/write_project.h"

#include <fmt/format.h>
#include <algorithm>

#include "core/city/terrain/building_ground.h"
#include "core/receivers/place_names.h"
#include "core/study/text/terrain_text.h"
#include "scenarios/project/edit_json.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/tables/grid_tiles.h"

namespace noonmark {

namespace {

void touch(Database& database, const char* table, const Box2& box) {
    touchLayer(database, table, double(box.low.x), double(box.low.y), double(box.high.x), double(box.high.y));
}

bool same(const std::vector<InputFile>& a, const std::vector<InputFile>& b) {
    return std::ranges::equal(a, b, [](const InputFile& x, const InputFile& y) {
        return x.path == y.path && x.bytes == y.bytes && x.sha256 == y.sha256;
    });
}

void writeInputs(Database& database, const std::vector<InputFile>& inputs) {
    database.execute("DELETE FROM inputs");
    Statement add = database.prepare("INSERT INTO inputs (path, bytes, sha256) VALUES (?, ?, ?)");
    for (const InputFile& input : inputs)
        add.run(input.path.string(), std::int64_t(input.bytes), input.sha256);
}

void writeLots(Database& database, const std::vector<NamedLot>& lots) {
    database.execute("DELETE FROM lots");
    Statement add = database.prepare("INSERT INTO lots (geom, name, area_m2, roads) VALUES (?, ?, ?, ?)");
    Box2 box;
    for (const NamedLot& lot : lots) {
        add.run(AsBlob{polygonBlob(lot.outline)}, lot.name, area(lot.outline), formatText(lot.roads));
        box.add(bounds(lot.outline));
    }
    touch(database, "lots", box);
}

void writeRegions(Database& database, const std::vector<Region>& regions) {
    database.execute("DELETE FROM regions");
    Statement add = database.prepare("INSERT INTO regions (geom, name, area_m2) VALUES (?, ?, ?)");
    Box2 box;
    for (const Region& region : regions) {
        add.run(AsBlob{multiPolygonBlob(region.polygons)}, region.name, area(region));
        box.add(bounds(region));
    }
    touch(database, "regions", box);
}

void writePlaces(Database& database, const std::vector<Place>& places) {
    database.execute("DELETE FROM places");
    Statement add =
        database.prepare("INSERT INTO places (geom, name, kind, source, area_m2) VALUES (?, ?, ?, ?, ?)");
    Box2 box;
    for (const Place& place : places) {
        add.run(AsBlob{multiPolygonBlob(place.polygons)}, place.name, nameOf(place.kind), place.source,
                area(place));
        box.add(bounds(place));
    }
    touch(database, "places", box);
}

void writeWeights(Database& database, const std::vector<TimeWeights>& tables) {
    database.execute("DELETE FROM time_weights; DELETE FROM time_weight_tables;");
    Statement addTable = database.prepare("INSERT INTO time_weight_tables (name) VALUES (?)");
    Statement add = database.prepare(
        "INSERT INTO time_weights (weight_table, name, first_month, first_day, last_month, last_day, "
        "from_min, to_min, "
        "weight) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const TimeWeights& table : tables) {
        addTable.run(table.name);
        const std::int64_t id = database.lastRow();
        for (const WeightedInterval& one : table.intervals)
            add.run(id, one.name, int(unsigned(one.first.month())), int(unsigned(one.first.day())),
                    int(unsigned(one.last.month())), int(unsigned(one.last.day())), int(one.from.count()),
                    int(one.to.count()), one.weight);
    }
}

void writeView(Database& database, const std::map<std::string, std::string>& view) {
    database.execute("DELETE FROM view_state");
    Statement add = database.prepare("INSERT INTO view_state (key, value) VALUES (?, ?)");
    for (const auto& [key, value] : view) add.run(key, value);
}

void writeGroundPicture(Database& database, const std::optional<GroundPictureFile>& picture) {
    picture ? setFact(database, groundPictureKey, formatText(*picture))
            : removeFact(database, groundPictureKey);
}

void writeResults(Database& database, const Project* before, const Project& after) {
    const auto holds = [](const Project& project, const auto& result) {
        return std::ranges::find(project.results, result) != project.results.end();
    };
    if (before != nullptr)
        for (const auto& result : before->results)
            if (!holds(after, result)) removeResult(database, result->name);
    for (const auto& result : after.results)
        if (before == nullptr || !holds(*before, result)) writeResult(database, *result);
}

}  // namespace

void setFact(Database& database, const std::string& key, const std::string& value) {
    database
        .prepare(
            "INSERT INTO noonmark (key, value) VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = "
            "excluded.value")
        .run(key, value);
}

void removeFact(Database& database, const std::string& key) {
    database.prepare("DELETE FROM noonmark WHERE key = ?").run(key);
}

std::string readFact(Database& database, const std::string& key) {
    Statement get = database.prepare("SELECT value FROM noonmark WHERE key = ?");
    get.begin(key);
    return get.step() ? get.text(0) : std::string();
}

void writeChanges(Database& database, const Project* before, const Project& after) {
    const auto changed = [&](auto member) { return before == nullptr || before->*member != after.*member; };
    if (changed(&Project::city)) writeCity(database, before ? before->city.get() : nullptr, *after.city);
    if (changed(&Project::attribution)) setFact(database, "attribution", after.attribution);
    if (before == nullptr || !same(before->inputs, after.inputs)) writeInputs(database, after.inputs);
    if (changed(&Project::reading)) writeReading(database, *after.reading);
    if (changed(&Project::lots)) writeLots(database, after.lots);
    if (changed(&Project::regions)) writeRegions(database, after.regions);
    if (changed(&Project::places)) writePlaces(database, after.places);
    if (changed(&Project::scenarios))
        writeScenarios(database, before ? before->scenarios : std::vector<Scenario>{}, after.scenarios);
    if (changed(&Project::weights)) writeWeights(database, after.weights);
    if (changed(&Project::periods)) writePeriods(database, after.periods);
    if (changed(&Project::views)) writeSavedViews(database, after.views);
    if (changed(&Project::results)) writeResults(database, before, after);
    if (changed(&Project::sheets)) writeSheetSettings(database, after.sheets);
    if (changed(&Project::groundPicture)) writeGroundPicture(database, after.groundPicture);
    if (changed(&Project::view)) writeView(database, after.view);
}

namespace {

// The building that an edit adds, for the layer of proposals; heights are above the ground.
struct BuiltBy {
    NewShape operator()(const Replace& edit) const { return edit.with; }
    NewShape operator()(const AddBuilding& edit) const { return edit.building; }
    NewShape operator()(const ImportMesh& edit) const {
        return std::make_shared<const Building>(placeBuilding(*edit.shape, edit.placement));
    }
    template <class Other>
    NewShape operator()(const Other&) const {
        return nullptr;
    }
};

class ScenarioWriter {
public:
    explicit ScenarioWriter(Database& database)
        : database_(database),
          addEdit_(database.prepare(
              "INSERT INTO edits (scenario, position, kind, words, value) VALUES (?, ?, ?, ?, ?)")),
          addProposal_(database.prepare(
              "INSERT INTO proposals (geom, scenario, building_id, name, height, min_height, edit) "
              "VALUES (?, ?, ?, ?, ?, ?, ?)")) {}

    // Edits before `first` are already in the tables.
    void write(std::size_t id, const Scenario& scenario, std::size_t first) {
        cut(id, first);
        database_.prepare("DELETE FROM scenarios WHERE id = ?").run(id);
        database_.prepare("INSERT INTO scenarios (id, name, base) VALUES (?, ?, ?)")
            .run(id, scenario.name, scenario.base);
        for (std::size_t i = first; i < scenario.edits.size(); ++i) {
            const Edit& edit = scenario.edits[i];
            addEdit_.run(id, i, getKind(edit), formatText(edit), toJson(edit));
            addProposals(database_.lastRow(), scenario.name, std::visit(BuiltBy{}, edit));
        }
    }

    void remove(std::size_t id) {
        cut(id, 0);
        database_.prepare("DELETE FROM scenarios WHERE id = ?").run(id);
    }

private:
    void cut(std::size_t id, std::size_t first) {
        database_
            .prepare(
                "DELETE FROM proposals WHERE edit IN (SELECT id FROM edits WHERE scenario = ? AND position "
                ">= ?)")
            .run(id, first);
        database_.prepare("DELETE FROM edits WHERE scenario = ? AND position >= ?").run(id, first);
    }

    void addProposals(std::int64_t edit, const std::string& scenario, const NewShape& built) {
        if (!built) return;
        for (const Part& part : built->parts)
            addProposal_.run(AsBlob{polygonBlob(part.footprint)}, scenario, built->sourceId, built->name,
                             part.topM, part.bottomM, edit);
    }

    Database& database_;
    Statement addEdit_, addProposal_;
};

// Number of equal edits at the start of both lists, which need not be written.
std::size_t sharedEdits(const Scenario& before, const Scenario& after) {
    if (before.name != after.name) return 0;
    const auto [old, made] = std::ranges::mismatch(before.edits, after.edits);
    return std::size_t(made - after.edits.begin());
}

// Another program may have deleted or numbered rows.
bool areNumbered(Database& database, std::size_t scenarios) {
    const auto rows = database.value(
        "SELECT count(*) || ' ' || ifnull(min(id), 1) || ' ' || ifnull(max(id), 0) FROM scenarios");
    return rows == fmt::format("{0} 1 {0}", scenarios);
}

void clearScenarios(Database& database) {
    database.execute("DELETE FROM proposals; DELETE FROM edits; DELETE FROM scenarios");
}

}  // namespace

void writeScenarios(Database& database, const std::vector<Scenario>& before,
                    const std::vector<Scenario>& after) {
    if (!areNumbered(database, before.size())) {
        clearScenarios(database);
        if (!before.empty()) return writeScenarios(database, {}, after);
    }
    ScenarioWriter writer(database);
    for (std::size_t i = 0; i < after.size(); ++i) {
        const bool was = i < before.size();
        if (was && before[i] == after[i]) continue;
        writer.write(i + 1, after[i], was ? sharedEdits(before[i], after[i]) : 0);
    }
    for (std::size_t i = after.size(); i < before.size(); ++i) writer.remove(i + 1);
    database.execute(
        "UPDATE gpkg_contents SET last_change = strftime('%Y-%m-%dT%H:%M:%fZ','now') WHERE table_name = "
        "'proposals'");
}

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
    if (before == nullptr || old.trees != after.trees) writeTrees(database, after.trees.get());
    BuildingWriter writer(database, after);
    const std::size_t maximum = std::max(old.buildings.size(), after.buildings.size());
    for (std::size_t i = 0; i < maximum; ++i) {
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
