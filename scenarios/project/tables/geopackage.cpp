#include "scenarios/project/tables/geopackage.h"

#include <fmt/format.h>

#include <optional>

#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/grid_tiles.h"

namespace noonmark {

namespace {

// OGC GeoPackage 1.3, annex C.
constexpr const char* geoPackageTables = R"sql(
CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY,
  organization TEXT NOT NULL, organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
CREATE TABLE gpkg_contents (table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE,
  description TEXT DEFAULT '', last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
  min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
CREATE TABLE gpkg_geometry_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL,
  CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name), CONSTRAINT uk_gc_table_name UNIQUE (table_name),
  CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
  CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id));
CREATE TABLE gpkg_extensions (table_name TEXT, column_name TEXT, extension_name TEXT NOT NULL, definition TEXT NOT NULL,
  scope TEXT NOT NULL, CONSTRAINT ge_tce UNIQUE (table_name, column_name, extension_name));
CREATE TABLE gpkg_tile_matrix_set (table_name TEXT NOT NULL PRIMARY KEY, srs_id INTEGER NOT NULL, min_x DOUBLE NOT NULL,
  min_y DOUBLE NOT NULL, max_x DOUBLE NOT NULL, max_y DOUBLE NOT NULL,
  CONSTRAINT fk_gtms_table_name FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
  CONSTRAINT fk_gtms_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id));
CREATE TABLE gpkg_tile_matrix (table_name TEXT NOT NULL, zoom_level INTEGER NOT NULL, matrix_width INTEGER NOT NULL,
  matrix_height INTEGER NOT NULL, tile_width INTEGER NOT NULL, tile_height INTEGER NOT NULL,
  pixel_x_size DOUBLE NOT NULL, pixel_y_size DOUBLE NOT NULL,
  CONSTRAINT pk_ttm PRIMARY KEY (table_name, zoom_level),
  CONSTRAINT fk_tmm_table_name FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name));
CREATE TABLE gpkg_2d_gridded_coverage_ancillary (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  tile_matrix_set_name TEXT NOT NULL UNIQUE, datatype TEXT NOT NULL DEFAULT 'integer', scale REAL NOT NULL DEFAULT 1.0,
  offset REAL NOT NULL DEFAULT 0.0, precision REAL DEFAULT 1.0, data_null REAL,
  grid_cell_encoding TEXT DEFAULT 'grid-value-is-center', uom TEXT, field_name TEXT DEFAULT 'Height',
  quantity_definition TEXT DEFAULT 'Height',
  CONSTRAINT fk_g2dgtct_name FOREIGN KEY (tile_matrix_set_name) REFERENCES gpkg_tile_matrix_set (table_name),
  CHECK (datatype in ('integer','float')));
CREATE TABLE gpkg_2d_gridded_tile_ancillary (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, tpudt_name TEXT NOT NULL,
  tpudt_id INTEGER NOT NULL, scale REAL NOT NULL DEFAULT 1.0, offset REAL NOT NULL DEFAULT 0.0, min REAL DEFAULT NULL,
  max REAL DEFAULT NULL, mean REAL DEFAULT NULL, std_dev REAL DEFAULT NULL,
  CONSTRAINT fk_g2dgtat_name FOREIGN KEY (tpudt_name) REFERENCES gpkg_contents(table_name), UNIQUE (tpudt_name, tpudt_id));
INSERT INTO gpkg_extensions VALUES
  ('gpkg_2d_gridded_coverage_ancillary', NULL, 'gpkg_2d_gridded_coverage', 'http://docs.opengeospatial.org/is/17-066r1/17-066r1.html', 'read-write'),
  ('gpkg_2d_gridded_tile_ancillary', NULL, 'gpkg_2d_gridded_coverage', 'http://docs.opengeospatial.org/is/17-066r1/17-066r1.html', 'read-write');
INSERT INTO gpkg_spatial_ref_sys VALUES
  ('Undefined cartesian SRS', -1, 'NONE', -1, 'undefined', 'undefined cartesian coordinate reference system'),
  ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', 'undefined geographic coordinate reference system'),
  ('WGS 84 geodetic', 4326, 'EPSG', 4326, 'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]', 'longitude/latitude on WGS 84');
)sql";

}  // namespace

void createGeoPackage(Database& database, const std::string& localWkt) {
    // The application id is "GPKG", the user version GeoPackage 1.3.
    database.execute("PRAGMA application_id = 1196444487; PRAGMA user_version = 10300;");
    database.execute(geoPackageTables);
    database
        .prepare(
            "INSERT INTO gpkg_spatial_ref_sys VALUES ('Local plane of the Noonmark project', ?, 'NONE', ?, "
            "?, "
            "'x east, y north, metres from the project''s origin')")
        .run(localSrsId, localSrsId, localWkt);
}

void createCoverage(Database& database, const CoverageTable& coverage) {
    const int across = (coverage.columns + tileCells - 1) / tileCells;
    const int down = (coverage.rows + tileCells - 1) / tileCells;
    const double east = coverage.westM + coverage.columns * coverage.cellM;
    const double south = coverage.northM - coverage.rows * coverage.cellM;
    const double side = tileCells * coverage.cellM;
    database.execute(
        fmt::format("CREATE TABLE {} (id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, zoom_level INTEGER NOT "
                    "NULL, tile_column INTEGER "
                    "NOT NULL, tile_row INTEGER NOT NULL, tile_data BLOB NOT NULL, UNIQUE (zoom_level, "
                    "tile_column, tile_row))",
                    coverage.table));
    database
        .prepare(
            "INSERT INTO gpkg_contents (table_name, data_type, identifier, min_x, min_y, max_x, max_y, "
            "srs_id) "
            "VALUES (?, '2d-gridded-coverage', ?, ?, ?, ?, ?, ?)")
        .run(coverage.table, coverage.identifier, coverage.westM, south, east, coverage.northM, localSrsId);
    database.prepare("INSERT INTO gpkg_tile_matrix_set VALUES (?, ?, ?, ?, ?, ?)")
        .run(coverage.table, localSrsId, coverage.westM, coverage.northM - down * side,
             coverage.westM + across * side, coverage.northM);
    database.prepare("INSERT INTO gpkg_tile_matrix VALUES (?, 0, ?, ?, ?, ?, ?, ?)")
        .run(coverage.table, across, down, tileCells, tileCells, coverage.cellM, coverage.cellM);
    database
        .prepare(
            "INSERT INTO gpkg_2d_gridded_coverage_ancillary (tile_matrix_set_name, datatype, data_null, "
            "grid_cell_encoding, uom, field_name, quantity_definition) VALUES (?, 'float', ?, "
            "'grid-value-is-area', "
            "?, ?, ?)")
        .run(coverage.table, tileNoData, coverage.unit, coverage.identifier, coverage.identifier);
    database
        .prepare(
            "INSERT INTO gpkg_extensions VALUES (?, 'tile_data', 'gpkg_2d_gridded_coverage', "
            "'http://docs.opengeospatial.org/is/17-066r1/17-066r1.html', 'read-write')")
        .run(coverage.table);
}

void dropCoverage(Database& database, const std::string& table) {
    for (const char* statement :
         {"DELETE FROM gpkg_2d_gridded_tile_ancillary WHERE tpudt_name = ?",
          "DELETE FROM gpkg_2d_gridded_coverage_ancillary WHERE tile_matrix_set_name = ?",
          "DELETE FROM gpkg_extensions WHERE table_name = ?",
          "DELETE FROM gpkg_tile_matrix WHERE table_name = ?",
          "DELETE FROM gpkg_tile_matrix_set WHERE table_name = ?",
          "DELETE FROM gpkg_contents WHERE table_name = ?"})
        database.prepare(statement).run(table);
    database.execute("DROP TABLE " + table);
}

void createPolygonLayer(Database& database, const PolygonTable& layer) {
    database.execute(fmt::format("CREATE TABLE {} (fid INTEGER PRIMARY KEY NOT NULL, geom BLOB, {})",
                                 layer.table, layer.columns));
    database
        .prepare(
            "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES (?, "
            "'features', ?, ?, ?)")
        .run(layer.table, layer.identifier, layer.description, localSrsId);
    database.prepare("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', 'POLYGON', ?, 0, 0)")
        .run(layer.table, localSrsId);
}

void dropPolygonLayer(Database& database, const std::string& table) {
    for (const char* statement : {"DELETE FROM gpkg_geometry_columns WHERE table_name = ?",
                                  "DELETE FROM gpkg_contents WHERE table_name = ?"})
        database.prepare(statement).run(table);
    database.execute("DROP TABLE IF EXISTS " + table);
}

void touchLayer(Database& database, const std::string& table, double westM, double southM, double eastM,
                double northM) {
    const bool any = westM <= eastM;
    const auto bound = [any](double value) { return any ? std::optional(value) : std::nullopt; };
    database
        .prepare(
            "UPDATE gpkg_contents SET last_change = strftime('%Y-%m-%dT%H:%M:%fZ','now'), min_x = ?, min_y = "
            "?, "
            "max_x = ?, max_y = ? WHERE table_name = ?")
        .run(bound(westM), bound(southM), bound(eastM), bound(northM), table);
}

}  // namespace noonmark
