#pragma once

#include <string>

#include "scenarios/project/tables/database.h"

namespace noonmark {

/// Creates the tables required by GeoPackage 1.3 in an empty database. `localWkt`: the project's coordinate
/// system.
void createGeoPackage(Database& database, const std::string& localWkt);

/// Parameters of createCoverage(): a layer of square cells (a "2d-gridded-coverage"), which QGIS shows as a
/// raster. Its tiles are rows of `table`.
struct CoverageTable {
    std::string table;
    std::string identifier;  ///< title in GIS programs
    std::string unit;
    double westM = 0, northM = 0, cellM = 1;
    int columns = 0, rows = 0;  ///< size in cells
};
void createCoverage(Database& database, const CoverageTable& coverage);
void dropCoverage(Database& database, const std::string& table);

/// Parameters of createPolygonLayer(). `columns`: SQL of the columns other than `fid` and `geom`.
struct PolygonTable {
    std::string table;
    std::string identifier;  ///< title in GIS programs
    std::string description;
    std::string columns;
};
void createPolygonLayer(Database& database, const PolygonTable& layer);
void dropPolygonLayer(Database& database, const std::string& table);  ///< no effect where there is none

/// Records the time of change and the bounding box of a layer.
void touchLayer(Database& database, const std::string& table, double westM, double southM, double eastM,
                double northM);

}  // namespace noonmark
