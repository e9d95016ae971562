#include <fmt/format.h>

#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/tables/grid_tiles.h"
#include "scenarios/project/tables/write_bands.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

namespace {

void writeTiles(Database& database, const std::string& table, const Grid& grid,
                const std::vector<float>& values) {
    Statement add = database.prepare(fmt::format(
        "INSERT INTO {} (zoom_level, tile_column, tile_row, tile_data) VALUES (0, ?, ?, ?)", table));
    Statement about =
        database.prepare("INSERT INTO gpkg_2d_gridded_tile_ancillary (tpudt_name, tpudt_id) VALUES (?, ?)");
    for (int row = 0; row * tileCells < grid.rows; ++row)
        for (int column = 0; column * tileCells < grid.columns; ++column) {
            const Bytes tile = encodeTile(grid, values, column, row);
            add.run(column, row, AsBlob{tile});
            about.run(table, database.lastRow());
        }
}

void writeLayer(Database& database, const SavedResult& result, std::int64_t id, std::size_t number) {
    const SavedLayer& layer = result.layers[number];
    const std::string table = fmt::format("result_{}_{}", id, number + 1);
    const Grid& grid = result.grid;
    createCoverage(database, {table, fmt::format("{}: {}", result.name, layer.name), layer.unit, grid.westM,
                              grid.northM(), grid.cellM, grid.columns, grid.rows});
    writeTiles(database, table, grid, layer.values);
    database.prepare("INSERT INTO result_layers (result, name, unit, tiles) VALUES (?, ?, ?, ?)")
        .run(id, layer.name, layer.unit, table);
    writeBands(database, result, layer, table);
}

}  // namespace

void writeResult(Database& database, const SavedResult& result) {
    const Grid& grid = result.grid;
    database
        .prepare(
            "INSERT INTO results (name, kind, scenario, baseline, settings, inputs, west_m, south_m, cell_m, "
            "columns, rows) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .run(result.name, result.kind, result.scenario, result.baseline, result.settings, result.inputs,
             grid.westM, grid.southM, grid.cellM, grid.columns, grid.rows);
    const std::int64_t id = database.lastRow();
    for (std::size_t i = 0; i < result.layers.size(); ++i) writeLayer(database, result, id, i);
    writeElements(database, id, result.elements);
}

void removeResult(Database& database, const std::string& name) {
    std::vector<std::string> tables;
    Statement find = database.prepare(
        "SELECT tiles FROM result_layers WHERE result IN (SELECT id FROM results WHERE name = ?)");
    for (find.begin(name); find.step();) tables.push_back(find.text(0));
    for (const std::string& table : tables) {
        dropCoverage(database, table);
        removeBands(database, table);
    }
    database.prepare("DELETE FROM result_elements WHERE result IN (SELECT id FROM results WHERE name = ?)")
        .run(name);
    database.prepare("DELETE FROM result_layers WHERE result IN (SELECT id FROM results WHERE name = ?)")
        .run(name);
    database.prepare("DELETE FROM results WHERE name = ?").run(name);
}

}  // namespace noonmark
