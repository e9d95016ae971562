#include "scenarios/project/tables/layer_styles.h"

#include <fmt/format.h>

#include <array>

namespace noonmark {

namespace {

constexpr const char* table = R"sql(
CREATE TABLE layer_styles (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, f_table_catalog TEXT(256),
  f_table_schema TEXT(256), f_table_name TEXT(256), f_geometry_column TEXT(256), styleName TEXT(30), styleQML TEXT,
  styleSLD TEXT, useAsDefault BOOLEAN, description TEXT, owner TEXT(30), ui TEXT(30),
  update_time DATETIME DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')));
INSERT INTO gpkg_contents (table_name, data_type, identifier) VALUES ('layer_styles', 'attributes', 'layer_styles');
)sql";

struct Fill {
    std::string fill;  // "r,g,b,a"
    const char* outline;
    double widthMm;
};

std::string symbol(int name, const Fill& fill) {
    return fmt::format(
        R"(<symbol type="fill" name="{}"><layer class="SimpleFill"><Option type="Map">)"
        R"(<Option type="QString" name="color" value="{}"/><Option type="QString" name="style" value="solid"/>)"
        R"(<Option type="QString" name="outline_color" value="{}"/>)"
        R"(<Option type="QString" name="outline_style" value="solid"/>)"
        R"(<Option type="QString" name="outline_width" value="{:g}"/>)"
        R"(<Option type="QString" name="outline_width_unit" value="MM"/></Option></layer></symbol>)",
        name, fill.fill, fill.outline, fill.widthMm);
}

std::string qml(const std::string& renderer) {
    return "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n<qgis version=\"3.22.0\" "
           "styleCategories=\"Symbology\">" +
           renderer + "<layerGeometryType>2</layerGeometryType></qgis>";
}

std::string single(const Fill& fill) {
    return qml("<renderer-v2 type=\"singleSymbol\"><symbols>" + symbol(0, fill) + "</symbols></renderer-v2>");
}

struct HeightClass {
    int fromM, toM;
    const char* colour;
};
constexpr std::array heightClasses{
    HeightClass{0, 12, "237,233,224,255"},  HeightClass{12, 25, "214,205,188,255"},
    HeightClass{25, 50, "183,168,145,255"}, HeightClass{50, 100, "146,128,106,255"},
    HeightClass{100, 200, "107,89,72,255"}, HeightClass{200, 2000, "68,53,42,255"},
};

std::string byHeight() {
    std::string ranges, symbols;
    for (std::size_t i = 0; i < heightClasses.size(); ++i) {
        const HeightClass& one = heightClasses[i];
        ranges +=
            fmt::format(R"(<range lower="{}" upper="{}" symbol="{}" label="{} to {} m" render="true"/>)",
                        one.fromM, one.toM, i, one.fromM, one.toM);
        symbols += symbol(int(i), {one.colour, "90,80,70,255", 0.1});
    }
    return qml(
        "<renderer-v2 type=\"graduatedSymbol\" attr=\"height\" graduatedMethod=\"GraduatedColor\"><ranges>" +
        ranges + "</ranges><symbols>" + symbols + "</symbols></renderer-v2>");
}

std::string byBand(const std::vector<ValueBand>& bands) {
    std::string categories, symbols;
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const auto& [low, high, colour, label] = bands[i];
        categories +=
            fmt::format(R"(<category value="{}" symbol="{}" label="{}" render="true"/>)", label, i, label);
        const std::string fill = fmt::format("{},{},{},255", colour.red, colour.green, colour.blue);
        symbols += symbol(int(i), {fill, "0,0,0,0", 0});
    }
    return qml("<renderer-v2 type=\"categorizedSymbol\" attr=\"label\"><categories>" + categories +
               "</categories><symbols>" + symbols + "</symbols></renderer-v2>");
}

struct Style {
    const char* name;
    std::string qml;
    const char* description;
};

void add(Database& database, const std::string& layer, const Style& style) {
    database
        .prepare(
            "INSERT INTO layer_styles (f_table_catalog, f_table_schema, f_table_name, f_geometry_column, "
            "styleName, styleQML, styleSLD, useAsDefault, description, owner) VALUES ('', '', ?, 'geom', ?, "
            "?, "
            "'', 1, ?, 'Noonmark')")
        .run(layer, style.name, style.qml, style.description);
}

}  // namespace

void addLayerStyles(Database& database) {
    database.execute(table);
    add(database, "buildings", {"Buildings by height", byHeight(), "Metres above the ground"});
    add(database, "proposals",
        {"Proposed buildings", single({"214,96,77,200", "140,40,30,255", 0.3}),
         "Buildings that scenarios add"});
    add(database, "lots", {"Lots", single({"255,255,255,0", "33,102,172,255", 0.4}), "Outlines"});
    add(database, "regions",
        {"Regions", single({"77,175,74,40", "35,120,40,255", 0.5}), "Where shadow is measured"});
    addPlaceStyle(database);
}

void addPlaceStyle(Database& database) {
    add(database, "places",
        {"Places", single({"146,197,122,110", "70,120,60,255", 0.3}), "Areas whose sunlight matters"});
}

void addBandStyle(Database& database, const std::string& table, const std::vector<ValueBand>& bands) {
    add(database, table, {"Bands", byBand(bands), "Colours as in the program"});
}

void removeStyle(Database& database, const std::string& table) {
    database.prepare("DELETE FROM layer_styles WHERE f_table_name = ?").run(table);
}

}  // namespace noonmark
