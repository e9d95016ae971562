#pragma once

#include <string>
#include <vector>

#include "scenarios/project/tables/database.h"

namespace noonmark {

/// The version of the tables that this program writes; docs/project-file.md lists all versions.
inline constexpr int schemaVersion = 2;

/// The warning that a file of version 1 is given, which holds none.
inline constexpr const char* noReadingWords =
    "warnings and settings of reading the city's files: the project was saved by a version that did not save "
    "them (file version 1); read the files again to have them";

/// Makes all tables of an empty database, a GeoPackage 1.3. `localWkt`: of the project's plane.
void createSchema(Database& database, const std::string& localWkt);

/// The version of the file's tables; 0 where it is no Noonmark project.
int versionOf(Database& database);

/// Throws DatabaseTrouble where a table of schemaVersion is missing, is a view or a virtual table, or lacks a
/// column; columns that are computed count as missing. Other tables are left alone.
void checkTables(Database& database);

/// The same of one table with these columns.
void checkTable(Database& database, const std::string& table, const std::vector<std::string>& columns);

/// Removes the spatial indexes that a GIS added to our layers. Their triggers do not run here, so that saving
/// would leave them wrong; a GIS makes them again.
void removeSpatialIndexes(Database& database);

/// Brings the tables from their version to schemaVersion, one step after the other, inside the caller's
/// transaction.
void migrate(Database& database);

}  // namespace noonmark
