#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// Error where a GeoPackage would have SQL run that its maker wrote: its own tables, or the layers that it
/// lists, are views or virtual tables. A view may go on for ever. Reads the file and writes nothing. Costs
/// milliseconds. Backend: geopackage_check_sqlite.cpp.
Result<void> checkGeoPackage(const std::filesystem::path& file);

/// Whether a file is a Noonmark project, whatever its name: an SQLite database with the table `noonmark`.
/// Error: it is a database, but cannot be read (damaged, locked). Writes nothing.
Result<bool> holdsProject(const std::filesystem::path& file);

/// Whether another program has written to the database and has not finished: what it wrote lies beside it.
bool isBeingWritten(const std::filesystem::path& database);

}  // namespace noonmark
