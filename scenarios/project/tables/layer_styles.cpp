#include "scenarios/project/tables/layer_styles.h"

#include <array>

#include "core/io/styles/layer_style.h"

namespace noonmark {

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

}  // namespace noonmark
