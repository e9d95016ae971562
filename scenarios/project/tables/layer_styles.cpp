#include "scenarios/project/tables/layer_styles.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/styles/qgis_style.h"
#include "core/receivers/band_polygons.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"

namespace noonmark {

namespace {

double largestOf(std::span<const float> values) {
    double largest = 0;
    for (const float value : values)
        if (!std::isnan(value)) largest = std::max(largest, std::abs(double(value)));
    return largest;
}

}  // namespace

ValueBands::ValueBands(std::span<const float> values, const std::string& unit, bool change)
    : scale_(legendScale(largestOf(values))),
      change_(change),
      each_(int(std::lround(scale_.top / scale_.tick))) {
    const double tick = scale_.tick;
    for (int i = change ? -each_ : 0; i < each_; ++i) {
        const double middle = (i + 0.5) * tick / scale_.top;
        bands_.push_back({i * tick, (i + 1) * tick, change ? impactRgb(middle) : shadowRgb(middle),
                          fmt::format("{:g} to {:g} {}", i * tick, (i + 1) * tick, unit)});
    }
}

int ValueBands::bandOf(float value) const {
    if (std::isnan(value) || (change_ && value == 0)) return -1;
    const int fromZero = std::min(each_ - 1, int(std::abs(double(value)) / scale_.tick));
    if (!change_) return fromZero;
    return value > 0 ? each_ + fromZero : each_ - 1 - fromZero;
}

namespace {

const std::array heightClasses{
    ColourClass{0, 12, {237, 233, 224}, "0 to 12 m"},
    ColourClass{12, 25, {214, 205, 188}, "12 to 25 m"},
    ColourClass{25, 50, {183, 168, 145}, "25 to 50 m"},
    ColourClass{50, 100, {146, 128, 106}, "50 to 100 m"},
    ColourClass{100, 200, {107, 89, 72}, "100 to 200 m"},
    ColourClass{200, 2000, {68, 53, 42}, "200 to 2000 m"},
};

std::string byHeight() {
    return graduatedStyle(StyledShape::polygons, "height", heightClasses, {"90,80,70,255", 0.1});
}

void add(Database& database, const std::string& layer, const LayerStyle& style) {
    database.execute(addStyleSql(layer, "geom", style));
}

}  // namespace

void addLayerStyles(Database& database) {
    for (const std::string& sql : styleTableSql()) database.execute(sql);
    add(database, "buildings", {"Buildings by height", byHeight(), "Metres above the ground"});
    add(database, "proposals",
        {"Proposed buildings", singleStyle("214,96,77,200", {"140,40,30,255", 0.3}),
         "Buildings that scenarios add"});
    add(database, "lots", {"Lots", singleStyle("255,255,255,0", {"33,102,172,255", 0.4}), "Outlines"});
    add(database, "regions",
        {"Regions", singleStyle("77,175,74,40", {"35,120,40,255", 0.5}), "Where shadow is measured"});
    addPlaceStyle(database);
}

void addPlaceStyle(Database& database) {
    add(database, "places",
        {"Places", singleStyle("146,197,122,110", {"70,120,60,255", 0.3}), "Areas whose sunlight matters"});
}

void addBandStyle(Database& database, const std::string& table, const std::vector<ColourClass>& bands) {
    add(database, table,
        {"Bands", categorizedStyle(StyledShape::polygons, "label", bands, {"0,0,0,0", 0}),
         "Colours as in the program"});
}

void removeStyle(Database& database, const std::string& table) {
    database.prepare("DELETE FROM layer_styles WHERE f_table_name = ?").run(table);
}

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
