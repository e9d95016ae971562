#include "scenarios/project/write_project.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/receivers/place_names.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"

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
        double areaM2 = 0;
        for (const Footprint& polygon : region.polygons) areaM2 += area(polygon);
        add.run(AsBlob{multiPolygonBlob(region.polygons)}, region.name, areaM2);
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

}  // namespace noonmark
