#include "scenarios/project/tables/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/warnings.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/tables/layer_styles.h"

namespace noonmark {

namespace {

// docs/project-file.md documents every column.
constexpr const char* projectTables = R"sql(
CREATE TABLE noonmark (id INTEGER PRIMARY KEY NOT NULL, key TEXT NOT NULL UNIQUE, value TEXT NOT NULL);
CREATE TABLE inputs (id INTEGER PRIMARY KEY NOT NULL, path TEXT NOT NULL, bytes INTEGER NOT NULL, sha256 TEXT NOT NULL);
CREATE TABLE buildings (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, building_id TEXT, source_id TEXT, name TEXT,
  status TEXT, height REAL, min_height REAL, ground_elevation REAL, height_source TEXT, hangs INTEGER,
  bottom_m REAL NOT NULL, top_m REAL NOT NULL, building INTEGER NOT NULL);
CREATE INDEX buildings_building ON buildings (building);
CREATE TABLE meshes (id INTEGER PRIMARY KEY NOT NULL, vertices BLOB NOT NULL, triangles BLOB NOT NULL);
CREATE TABLE terrain (id INTEGER PRIMARY KEY NOT NULL, west_m REAL NOT NULL, south_m REAL NOT NULL, cell_m REAL NOT NULL,
  columns INTEGER NOT NULL, rows INTEGER NOT NULL, elevations_m BLOB NOT NULL);
CREATE TABLE lots (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, name TEXT, area_m2 REAL, roads TEXT);
CREATE TABLE regions (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, name TEXT, area_m2 REAL);
CREATE TABLE scenarios (id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL, base TEXT NOT NULL);
CREATE TABLE edits (id INTEGER PRIMARY KEY NOT NULL, scenario INTEGER NOT NULL, position INTEGER NOT NULL,
  kind TEXT NOT NULL, words TEXT NOT NULL, value TEXT NOT NULL, UNIQUE (scenario, position));
CREATE TABLE proposals (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, scenario TEXT, building_id TEXT, name TEXT,
  height REAL, min_height REAL, edit INTEGER NOT NULL);
CREATE INDEX proposals_edit ON proposals (edit);
CREATE TABLE time_weight_tables (id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL);
CREATE TABLE time_weights (id INTEGER PRIMARY KEY NOT NULL, weight_table INTEGER NOT NULL, name TEXT NOT NULL,
  first_month INTEGER NOT NULL, first_day INTEGER NOT NULL, last_month INTEGER NOT NULL, last_day INTEGER NOT NULL,
  from_min INTEGER NOT NULL, to_min INTEGER NOT NULL, weight REAL NOT NULL);
CREATE TABLE periods (id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL, start TEXT NOT NULL, days INTEGER NOT NULL,
  from_min INTEGER NOT NULL, hours REAL NOT NULL, step_min REAL NOT NULL, after_sunrise_min INTEGER,
  before_sunset_min INTEGER, sunrise_rule TEXT, zone TEXT NOT NULL, refraction INTEGER NOT NULL);
CREATE TABLE results (id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL UNIQUE, kind TEXT NOT NULL, scenario TEXT NOT NULL,
  baseline TEXT NOT NULL, settings TEXT NOT NULL, inputs TEXT NOT NULL, west_m REAL NOT NULL, south_m REAL NOT NULL,
  cell_m REAL NOT NULL, columns INTEGER NOT NULL, rows INTEGER NOT NULL);
CREATE TABLE result_layers (id INTEGER PRIMARY KEY NOT NULL, result INTEGER NOT NULL, name TEXT NOT NULL,
  unit TEXT NOT NULL, tiles TEXT NOT NULL);
CREATE TABLE view_state (id INTEGER PRIMARY KEY NOT NULL, key TEXT NOT NULL UNIQUE, value TEXT NOT NULL);
)sql";

// Since version 2. Many warnings share a text, so each text is stored once.
constexpr const char* readingTables = R"sql(
CREATE TABLE warning_texts (id INTEGER PRIMARY KEY NOT NULL, kind TEXT NOT NULL, what TEXT NOT NULL);
CREATE TABLE warnings (id INTEGER PRIMARY KEY NOT NULL, text INTEGER NOT NULL, place TEXT NOT NULL);
)sql";
constexpr std::array readingTableNames{"warning_texts", "warnings"};

// Since version 3.
constexpr const char* placeTable = R"sql(
CREATE TABLE places (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, name TEXT, kind TEXT, source TEXT, area_m2 REAL);
)sql";
constexpr const char* sheetTable = R"sql(
CREATE TABLE sheet_settings (id INTEGER PRIMARY KEY NOT NULL, key TEXT NOT NULL UNIQUE, value BLOB NOT NULL);
)sql";

// Since version 4.
constexpr const char* contextTable = R"sql(
CREATE TABLE context (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, kind TEXT, name TEXT, width_m REAL);
)sql";

// Since version 6.
constexpr const char* viewTable = R"sql(
CREATE TABLE saved_views (id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL, target_x_m REAL NOT NULL,
  target_y_m REAL NOT NULL, target_z_m REAL NOT NULL, distance_m REAL NOT NULL, heading_deg REAL NOT NULL,
  pitch_deg REAL NOT NULL, projection TEXT NOT NULL, date TEXT, at_min INTEGER);
)sql";

// Since version 7.
constexpr const char* elementTable = R"sql(
CREATE TABLE result_elements (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, result INTEGER NOT NULL,
  element_id TEXT NOT NULL, kind TEXT NOT NULL, building TEXT NOT NULL, building_name TEXT NOT NULL, floor INTEGER,
  azimuth_deg REAL, x_m REAL NOT NULL, y_m REAL NOT NULL, z_m REAL NOT NULL, normal_x REAL NOT NULL,
  normal_y REAL NOT NULL, normal_z REAL NOT NULL, left_m REAL NOT NULL, below_m REAL NOT NULL, right_m REAL NOT NULL,
  above_m REAL NOT NULL, sunlit_min REAL NOT NULL, gross_min REAL NOT NULL, continuous_min REAL NOT NULL,
  longest_sun_min REAL NOT NULL, sunlit_min_01 REAL, sunlit_min_02 REAL, sunlit_min_03 REAL, sunlit_min_04 REAL,
  sunlit_min_05 REAL, sunlit_min_06 REAL, sunlit_min_07 REAL, sunlit_min_08 REAL, sunlit_min_09 REAL,
  sunlit_min_10 REAL, sunlit_min_11 REAL, sunlit_min_12 REAL);
CREATE INDEX result_elements_result ON result_elements (result);
)sql";

// Since version 8.
constexpr const char* sectionColumn = "ALTER TABLE saved_views ADD COLUMN section TEXT";

// Since version 9.
constexpr const char* periodSettingsColumn = "ALTER TABLE periods ADD COLUMN settings TEXT";

// Since version 10.
constexpr const char* treeTable = R"sql(
CREATE TABLE trees (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, tree_id TEXT, species TEXT, height_m REAL,
  crown_diameter_m REAL, crown_base_m REAL, shape TEXT, evergreen INTEGER, height_source TEXT, crown_source TEXT,
  leaf_on REAL, leaf_off REAL);
)sql";

// Since version 11: leaf days of single trees, "04-15".
constexpr std::array treeLeafColumns{"leaf_on_day", "leaf_off_day"};

struct FeatureTable {
    const char* table;
    const char* type;
    const char* identifier;
    const char* description;
};
constexpr std::array featureTables{
    FeatureTable{"buildings", "POLYGON", "Buildings",
                 "The existing city, one feature per building part; heights in metres"},
    FeatureTable{"proposals", "POLYGON", "Proposed buildings",
                 "Buildings that the scenarios add, one feature per building part"},
    FeatureTable{"lots", "POLYGON", "Lots", "Ground that may be built on"},
    FeatureTable{"regions", "MULTIPOLYGON", "Regions", "Where shadow is measured"},
};
constexpr FeatureTable placeLayer{"places", "MULTIPOLYGON", "Places", "Areas whose sunlight matters"};
constexpr FeatureTable contextLayer{"context", "GEOMETRY", "Context",
                                    "Streets, paths, parks, water and trees, drawn for orientation"};
constexpr FeatureTable elementLayer{"result_elements", "MULTIPOINT", "Points of results",
                                    "Sun and shadow at points of facades, windows and planes"};
constexpr FeatureTable treeLayer{"trees", "POINT", "Trees", "Trees of the existing city; metres"};
constexpr std::array attributeTables{
    "noonmark",           "inputs",       "meshes",  "terrain", "scenarios",     "edits",
    "time_weight_tables", "time_weights", "periods", "results", "result_layers", "view_state"};

Statement contentsOf(Database& database) {
    return database.prepare(
        "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES (?, ?, ?, "
        "?, ?)");
}

void addReadingTables(Database& database) {
    database.execute(readingTables);
    Statement contents = contentsOf(database);
    for (const char* table : readingTableNames)
        contents.run(table, "attributes", table, "", std::optional<int>{});
}

void registerLayer(Database& database, const FeatureTable& layer) {
    contentsOf(database).run(layer.table, "features", layer.identifier, layer.description, localSrsId);
    database.prepare("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, 0, 0)")
        .run(layer.table, layer.type, localSrsId);
}

void addPlaceTable(Database& database) {
    database.execute(placeTable);
    registerLayer(database, placeLayer);
}

void addContextTable(Database& database) {
    database.execute(contextTable);
    registerLayer(database, contextLayer);
}

void addSheetTable(Database& database) {
    database.execute(sheetTable);
    contentsOf(database).run("sheet_settings", "attributes", "sheet_settings", "", std::optional<int>{});
}

void addViewTable(Database& database) {
    database.execute(viewTable);
    contentsOf(database).run("saved_views", "attributes", "saved_views", "", std::optional<int>{});
}

void addElementTable(Database& database) {
    database.execute(elementTable);
    registerLayer(database, elementLayer);
}

void addTreeTable(Database& database) {
    database.execute(treeTable);
    registerLayer(database, treeLayer);
}

void addTreeLeafColumns(Database& database) {
    for (const char* column : treeLeafColumns)
        database.execute(fmt::format("ALTER TABLE trees ADD COLUMN {} TEXT", column));
}

void registerTables(Database& database) {
    Statement contents = contentsOf(database);
    for (const FeatureTable& layer : featureTables) registerLayer(database, layer);
    for (const char* table : attributeTables)
        contents.run(table, "attributes", table, "", std::optional<int>{});
}

// Version 1 stored neither the warnings of reading nor the settings; every later report states that.
void toVersion2(Database& database) {
    addReadingTables(database);
    database.prepare("INSERT INTO warning_texts (id, kind, what) VALUES (1, ?, ?)")
        .run(nameOf(WarningKind::leftOut), noReadingText);
    database.prepare("INSERT INTO warnings (text, place) VALUES (1, ?)").run("project file");
}

// A table of that name can only be one that a GIS program added; it is not overwritten.
void refuseForeignTable(Database& database, const char* name) {
    Statement found = database.prepare("SELECT 1 FROM sqlite_master WHERE name = ? COLLATE NOCASE");
    found.begin(name);
    if (found.step())
        throwDamaged(
            fmt::format("it has a table '{}' that is not the program's; rename it in a GIS program", name));
}

void toVersion3(Database& database) {
    refuseForeignTable(database, "places");
    refuseForeignTable(database, "sheet_settings");
    addPlaceTable(database);
    addSheetTable(database);
    if (database.value("SELECT 1 FROM sqlite_master WHERE name = 'layer_styles' AND type = 'table'"))
        addPlaceStyle(database);
}

void toVersion4(Database& database) {
    refuseForeignTable(database, "context");
    addContextTable(database);
}

// A column of that name can only be one that another program added; it is not overwritten.
void refuseForeignColumn(Database& database, const char* table, const char* column) {
    Statement found = database.prepare("SELECT 1 FROM pragma_table_info(?) WHERE name = ? COLLATE NOCASE");
    found.begin(table, column);
    if (found.step())
        throwDamaged(fmt::format(
            "its table '{}' has a column '{}' that is not the program's; rename it in a GIS program", table,
            column));
}

void toVersion5(Database& database) {
    refuseForeignColumn(database, "lots", "roads");
    database.execute("ALTER TABLE lots ADD COLUMN roads TEXT");
}

void toVersion6(Database& database) {
    refuseForeignTable(database, "saved_views");
    addViewTable(database);
}

void toVersion7(Database& database) {
    refuseForeignTable(database, "result_elements");
    addElementTable(database);
}

void toVersion8(Database& database) {
    refuseForeignColumn(database, "saved_views", "section");
    database.execute(sectionColumn);
}

void toVersion9(Database& database) {
    refuseForeignColumn(database, "periods", "settings");
    database.execute(periodSettingsColumn);
    addPeriodSettings(database);
}

void toVersion10(Database& database) {
    refuseForeignTable(database, "trees");
    addTreeTable(database);
}

void toVersion11(Database& database) {
    for (const char* column : treeLeafColumns) refuseForeignColumn(database, "trees", column);
    addTreeLeafColumns(database);
}

// Element i migrates from version 1 + i to the next. The tests contain an old file of every version.
const std::vector<std::function<void(Database&)>>& migrations() {
    static const std::vector<std::function<void(Database&)>> steps{
        toVersion2, toVersion3, toVersion4, toVersion5,  toVersion6,
        toVersion7, toVersion8, toVersion9, toVersion10, toVersion11};
    return steps;
}

}  // namespace

void createSchema(Database& database, const std::string& localWkt) {
    createGeoPackage(database, localWkt);
    database.execute(projectTables);
    registerTables(database);
    addReadingTables(database);
    addPlaceTable(database);
    addSheetTable(database);
    addContextTable(database);
    addViewTable(database);
    database.execute(sectionColumn);
    database.execute(periodSettingsColumn);
    addElementTable(database);
    addTreeTable(database);
    addTreeLeafColumns(database);
    addLayerStyles(database);
    database.prepare("INSERT INTO noonmark (key, value) VALUES ('schema_version', ?)")
        .run(std::to_string(schemaVersion));
}

int versionOf(Database& database) {
    const auto table = database.value(
        "SELECT 1 FROM sqlite_master WHERE name = 'noonmark' AND type = 'table' AND rootpage > 0");
    if (!table) return 0;
    const auto version = database.value("SELECT value FROM noonmark WHERE key = 'schema_version'");
    return version ? std::atoi(version->c_str()) : 0;
}

void migrate(Database& database) {
    const int version = versionOf(database);
    for (int next = version; next < schemaVersion; ++next) migrations().at(std::size_t(next - 1))(database);
    if (version < schemaVersion)
        database.prepare("UPDATE noonmark SET value = ? WHERE key = 'schema_version'")
            .run(std::to_string(schemaVersion));
}

}  // namespace noonmark
