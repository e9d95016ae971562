#pragma once

#include <string>
#include <vector>

#include "scenarios/project/tables/database.h"

namespace noonmark {

/// Schema version that this program writes; docs/project-file.md lists all versions.
inline constexpr int schemaVersion = 11;

/// Warning added to files of version 1, which store no warnings.
inline constexpr const char* noReadingText =
    "warnings and settings of reading the city's files: the project was saved by a version that did not save "
    "them (file version 1); read the files again to have them";

/// Creates all tables in an empty database, a GeoPackage 1.3. `localWkt`: the project's coordinate system.
void createSchema(Database& database, const std::string& localWkt);

/// Fills the column `settings` of the table `periods`, which version 9 added, from the others. Throws
/// DatabaseError for a period that makes no sense.
void addPeriodSettings(Database& database);

/// Schema version of the file; 0 where it is not a Noonmark project.
int versionOf(Database& database);

/// Throws DatabaseError where a table of schemaVersion is missing, is a view or a virtual table, or lacks a
/// column. Generated columns count as missing. Other tables are ignored.
void checkTables(Database& database);

/// Checks one table in the same way.
void checkTable(Database& database, const std::string& table, const std::vector<std::string>& columns);

/// Removes the spatial indexes that a GIS program added to our layers. Their triggers do not run here, so
/// saving would leave the indexes wrong; a GIS program creates them again.
void removeSpatialIndexes(Database& database);

/// Makes our tables exactly ours again, before a save: a constraint or an index that another program added
/// could make it lose rows in silence. A table that differs is copied into one of ours, with the columns that
/// were added; foreign indexes are dropped. Throws DatabaseError where its rows do not fit.
void restoreTableDefinitions(Database& database);

/// Migrates the tables version by version to schemaVersion, inside the caller's transaction.
void migrate(Database& database);

}  // namespace noonmark
