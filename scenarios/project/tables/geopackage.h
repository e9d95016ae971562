#pragma once

#include <string>

#include "scenarios/project/tables/database.h"

namespace noonmark {

/// The tables that every GeoPackage 1.3 has, in an empty database. `localWkt`: of the project's plane.
void createGeoPackage(Database& database, const std::string& localWkt);

/// Adds a layer of square cells (a "2d-gridded-coverage"), which QGIS shows as a raster. Its tiles are rows
/// of `table`.
struct CoverageTable {
    std::string table;
    std::string identifier;  ///< what GIS programs call it
    std::string unit;
    double westM = 0, northM = 0, cellM = 1;
    int columns = 0, rows = 0;  ///< cells
};
void createCoverage(Database& database, const CoverageTable& coverage);
void dropCoverage(Database& database, const std::string& table);

/// Adds a layer of polygons. `columns`: SQL of its columns beside `fid` and `geom`.
struct PolygonTable {
    std::string table;
    std::string identifier;  ///< what GIS programs call it
    std::string description;
    std::string columns;
};
void createPolygonLayer(Database& database, const PolygonTable& layer);
void dropPolygonLayer(Database& database, const std::string& table);  ///< nothing where there is none

/// Notes when a layer changed, and what box its features fill now.
void touchLayer(Database& database, const std::string& table, double westM, double southM, double eastM,
                double northM);

}  // namespace noonmark
