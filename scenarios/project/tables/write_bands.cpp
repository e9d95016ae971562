#include "scenarios/project/tables/write_bands.h"

#include <fmt/format.h>

#include "core/receivers/band_polygons.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/tables/layer_styles.h"

namespace noonmark {

namespace {

std::string bandsTable(const std::string& tiles) { return tiles + "_bands"; }

void writePolygons(Database& database, const std::string& table, const Grid& grid,
                   const std::vector<float>& values, const ValueBands& bands) {
    std::vector<int> bandOfCell;
    for (const float value : values) bandOfCell.push_back(bands.bandOf(value));
    Statement add = database.prepare(
        fmt::format("INSERT INTO {} (geom, label, low, high, area_m2) VALUES (?, ?, ?, ?, ?)", table));
    for (const BandPolygon& polygon : traceBands(grid, std::move(bandOfCell))) {
        const ColourClass& band = bands.bands().at(std::size_t(polygon.band));
        const Bytes shape = polygonBlob(polygon.outline);
        add.run(AsBlob{shape}, band.label, band.low, band.high, area(polygon.outline));
    }
}

}  // namespace

void writeBands(Database& database, const SavedResult& result, const SavedLayer& layer,
                const std::string& tiles) {
    const std::string table = bandsTable(tiles);
    const Grid& grid = result.grid;
    createPolygonLayer(database,
                       {table, fmt::format("{}: {}, bands", result.name, layer.name),
                        "Areas between two values, made from the layer of cells; Noonmark does not read them",
                        "label TEXT, low REAL, high REAL, area_m2 REAL"});
    const ValueBands bands(layer.values, layer.unit, result.kind != "study");
    addBandStyle(database, table, bands.bands());
    writePolygons(database, table, grid, layer.values, bands);
    touchLayer(database, table, grid.westM, grid.southM, grid.westM + grid.columns * grid.cellM,
               grid.northM());
}

void removeBands(Database& database, const std::string& tiles) {
    dropPolygonLayer(database, bandsTable(tiles));
    removeStyle(database, bandsTable(tiles));
}

}  // namespace noonmark
