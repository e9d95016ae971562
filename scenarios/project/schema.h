#pragma once

#include <string>

#include "scenarios/project/database.h"

namespace noonmark {

/// The version of the tables that this program writes; docs/project-file.md lists all versions.
inline constexpr int schemaVersion = 1;

/// Makes all tables of an empty database, a GeoPackage 1.3. `localWkt`: of the project's plane.
void createSchema(Database& database, const std::string& localWkt);

/// The version of the file's tables; 0 where it is no Noonmark project.
int versionOf(Database& database);

/// Brings the tables from their version to schemaVersion, one step after the other, inside the caller's
/// transaction.
void migrate(Database& database);

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

/// Notes when a layer changed, and what box its features fill now.
void touchLayer(Database& database, const std::string& table, double westM, double southM, double eastM,
                double northM);

}  // namespace noonmark
