#include "scenarios/project/read_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/safe_text.h"
#include "core/receivers/made_names.h"
#include "core/receivers/place_names.h"
#include "scenarios/project/edit_json.h"
#include "scenarios/project/tables/database.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/grid_tiles.h"
#include "scenarios/project/tables/schema.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

namespace {

std::vector<InputFile> readInputs(Database& database) {
    std::vector<InputFile> inputs;
    Statement row = database.prepare("SELECT path, bytes, sha256 FROM inputs ORDER BY id");
    while (row.step()) inputs.push_back({row.text(0), std::uintmax_t(row.integer(1)), row.text(2)});
    return inputs;
}

// A lot drawn in a GIS program may have several pieces; each piece becomes a lot.
std::vector<NamedLot> readLots(Database& database) {
    std::vector<NamedLot> lots;
    Statement row = database.prepare("SELECT fid, geom, name, roads FROM lots ORDER BY fid");
    while (row.step()) {
        const auto polygons = toPolygons(row.blob(1));
        if (!polygons) throwDamaged("a lot has an invalid outline");
        const std::string name =
            row.isNull(2) ? fmt::format("lot {}", row.integer(0)) : cleanText(row.text(2));
        const auto roads = parseRoads(row.text(3));
        if (!roads) throwDamaged(fmt::format("lot {}: {}", name, roads.error().text()));
        for (std::size_t i = 0; i < polygons->size(); ++i)
            lots.push_back({numberName(name, i + 1), (*polygons)[i], *roads});
    }
    return lots;
}

std::vector<Region> readRegions(Database& database) {
    std::vector<Region> regions;
    Statement row = database.prepare("SELECT fid, geom, name FROM regions ORDER BY fid");
    while (row.step()) {
        auto polygons = toPolygons(row.blob(1));
        if (!polygons) throwDamaged("a region has an invalid outline");
        const std::string name =
            row.isNull(2) ? fmt::format("region {}", row.integer(0)) : cleanText(row.text(2));
        regions.push_back({name, *std::move(polygons)});
    }
    return regions;
}

// A place drawn in a GIS program may lack a name or a kind.
std::vector<Place> readPlaces(Database& database) {
    std::vector<Place> places;
    Statement row = database.prepare("SELECT fid, geom, name, kind, source FROM places ORDER BY fid");
    while (row.step()) {
        auto polygons = toPolygons(row.blob(1));
        if (!polygons || polygons->empty()) throwDamaged("a place has an invalid outline");
        places.push_back({cleanName(row.text(2)), parsePlaceKind(row.text(3)).value_or(PlaceKind::other),
                          *std::move(polygons), cleanText(row.text(4))});
        if (places.back().source.empty()) places.back().source = fmt::format("place {}", row.integer(0));
    }
    makeNamesUnique(places);
    return places;
}

std::vector<Edit> readEdits(Database& database, std::int64_t scenario) {
    std::vector<Edit> edits;
    Statement row = database.prepare("SELECT kind, value FROM edits WHERE scenario = ? ORDER BY position");
    for (row.begin(scenario); row.step();) {
        auto edit = parseEdit(row.text(0), row.text(1));
        if (!edit) throwDamaged(edit.error().what);
        edits.push_back(*std::move(edit));
    }
    return edits;
}

std::vector<Scenario> readScenarios(Database& database) {
    std::vector<Scenario> scenarios;
    Statement row = database.prepare("SELECT id, name, base FROM scenarios ORDER BY id");
    while (row.step())
        scenarios.push_back(
            {cleanText(row.text(1)), cleanText(row.text(2)), readEdits(database, row.integer(0))});
    return scenarios;
}

std::chrono::month_day dayOf(const CheckedRow& row, int column) {
    return {std::chrono::month(unsigned(row.integer(column, "month", {1, 12}))),
            std::chrono::day(unsigned(row.integer(column + 1, "day", {1, 31})))};
}

constexpr std::size_t maxIntervals = 1000;  // checked pairwise for overlap

std::vector<TimeWeights> readWeights(Database& database) {
    std::vector<TimeWeights> tables;
    Statement row = database.prepare(
        "SELECT t.id, t.name, w.name, first_month, first_day, last_month, last_day, from_min, to_min, weight "
        "FROM time_weight_tables t JOIN time_weights w ON w.weight_table = t.id ORDER BY t.id, w.id");
    std::int64_t last = 0;
    while (row.step()) {
        if (row.integer(0) != last) tables.push_back({cleanText(row.text(1)), {}});
        last = row.integer(0);
        const CheckedRow checked(row, "time_weights");
        if (tables.back().intervals.size() == maxIntervals) checked.refuse("too many intervals");
        tables.back().intervals.push_back({cleanText(row.text(2)), dayOf(checked, 3), dayOf(checked, 5),
                                           std::chrono::minutes(checked.integer(7, "from_min", dayMinutes)),
                                           std::chrono::minutes(checked.integer(8, "to_min", dayMinutes)),
                                           checked.number(9, "weight", {-1, 1})});
    }
    return tables;
}

std::map<std::string, std::string> readView(Database& database) {
    std::map<std::string, std::string> view;
    Statement row = database.prepare("SELECT key, value FROM view_state");
    while (row.step()) view[row.text(0)] = row.text(1);
    return view;
}

// Whether a name is one that save_result.cpp gives to a result's layers. No other table may be read, or
// dropped with the result.
bool isTileTable(std::string_view name) {
    constexpr std::string_view start = "result_";
    if (!name.starts_with(start)) return false;
    const std::string_view numbers = name.substr(start.size());
    const auto bar = numbers.find('_');
    return bar != 0 && bar + 1 < numbers.size() && numbers.find_first_not_of("0123456789_") == numbers.npos &&
           numbers.find('_', bar + 1) == numbers.npos;
}

// A grid takes memory for every cell, so its tiles must all be there.
void checkTileCount(Database& database, const std::string& table, const Grid& grid) {
    const auto along = [](int cells) { return std::int64_t((cells + tileCells - 1) / tileCells); };
    const auto found = database.value("SELECT count(*) FROM " + table + " WHERE zoom_level = 0");
    if (found != std::to_string(along(grid.columns) * along(grid.rows)))
        throwDamaged(fmt::format("table {}: tiles are missing", table));
}

SavedLayer readLayer(Database& database, const Statement& row, const Grid& grid) {
    SavedLayer layer{row.text(0), row.text(1), {}};
    const std::string table = row.text(2);
    if (!isTileTable(table)) throwDamaged(fmt::format("'{}' is not a table of a result", table));
    checkTable(database, table, {"id", "zoom_level", "tile_column", "tile_row", "tile_data"});
    checkTileCount(database, table, grid);
    layer.values.assign(grid.size(), std::numeric_limits<float>::quiet_NaN());
    Statement tile = database.prepare("SELECT id, tile_column, tile_row, tile_data FROM " + table +
                                      " WHERE zoom_level = 0");
    const int lastColumn = (grid.columns - 1) / tileCells, lastRow = (grid.rows - 1) / tileCells;
    while (tile.step()) {
        const CheckedRow checked(tile, table.c_str());
        const int column = checked.integer(1, "tile_column", {0, double(lastColumn)});
        const int line = checked.integer(2, "tile_row", {0, double(lastRow)});
        if (!decodeTile(tile.blob(3), grid, column, line, layer.values)) checked.refuse("a broken tile");
    }
    for (const float value : layer.values)
        if (!std::isnan(value) && !isWithin(double(value), layerLimits))
            throwDamaged(fmt::format("table {}: a value is out of range", table));
    return layer;
}

}  // namespace

std::vector<std::shared_ptr<const SavedResult>> readResults(Database& database) {
    std::vector<std::shared_ptr<const SavedResult>> results;
    Statement row = database.prepare(
        "SELECT id, name, kind, scenario, baseline, settings, inputs, west_m, south_m, cell_m, columns, rows "
        "FROM results ORDER BY id");
    std::size_t cells = 0;
    while (row.step()) {
        SavedResult result{cleanText(row.text(1)),
                           row.text(2),
                           cleanText(row.text(3)),
                           cleanText(row.text(4)),
                           row.text(5),
                           row.text(6),
                           {},
                           {}};
        result.grid = CheckedRow(row, "results").grid(7);
        Statement layer =
            database.prepare("SELECT name, unit, tiles FROM result_layers WHERE result = ? ORDER BY id");
        for (layer.begin(row.integer(0)); layer.step();) {
            cells += result.grid.size();
            if (cells > maxLayerCells)
                throwDamaged(fmt::format("its results have more than {} cells", maxLayerCells));
            result.layers.push_back(readLayer(database, layer, result.grid));
        }
        result.elements = readElements(database, row.integer(0));
        results.push_back(std::make_shared<const SavedResult>(std::move(result)));
    }
    return results;
}

Project readProject(Database& database) {
    Project project;
    Warnings warnings;
    project.city = readCityTables(database, warnings);
    project.attribution = readFact(database, "attribution");
    project.inputs = readInputs(database);
    project.reading = readReading(database);
    if (!warnings.empty()) {
        auto reading = std::make_shared<CityReading>(project.reading ? *project.reading : CityReading());
        for (const Warning& warning : warnings)  // those of an earlier opening may be saved among them
            if (std::ranges::none_of(reading->warnings, [&](const Warning& known) {
                    return known.what == warning.what && known.where == warning.where;
                }))
                reading->warnings.push_back(warning);
        project.reading = std::move(reading);
    }
    project.lots = readLots(database);
    project.regions = readRegions(database);
    project.places = readPlaces(database);
    project.scenarios = readScenarios(database);
    project.weights = readWeights(database);
    project.periods = readPeriods(database);
    project.views = readSavedViews(database);
    project.results = readResults(database);
    project.sheets = readSheetSettings(database);
    project.groundPicture = parseGroundPicture(readFact(database, groundPictureKey));
    project.view = readView(database);
    const std::string buildings = readFact(database, "buildings");
    if (buildings != std::to_string(project.city->buildings.size())) throwDamaged("buildings are missing");
    return project;
}

}  // namespace noonmark
