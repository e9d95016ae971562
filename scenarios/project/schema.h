#pragma once

#include <string>

#include "scenarios/project/database.h"

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

/// Brings the tables from their version to schemaVersion, one step after the other, inside the caller's
/// transaction.
void migrate(Database& database);

}  // namespace noonmark
