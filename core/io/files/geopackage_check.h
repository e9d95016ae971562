#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// The most layers of a file. Each takes time and memory before the first of its features is read.
inline constexpr int maxLayers = 1000;

/// Error if reading a GeoPackage would run SQL from the file or take more memory than its size explains: its
/// system tables, or the layers that it lists, are views or virtual tables; columns are computed; its tiles
/// are huge; it has more than maxLayers; or what lies beside it is not harmless (checkBeside). A view may
/// run without end. Reads the file and writes nothing. Takes milliseconds. Backend:
/// geopackage_check_sqlite.cpp.
Result<void> checkGeoPackage(const std::filesystem::path& file);

/// Makes a GeoPackage that GDAL has opened (its SQLITE_HANDLE) refuse values of more than 100 MB before it
/// allocates them, and end its queries when this thread's StopScope is stopped.
void limitGeoPackage(void* database);

/// Whether a file is a Noonmark project, whatever its name: an SQLite database with the table `noonmark`.
/// Error: it is a database that cannot be read (damaged, locked). Writes nothing.
Result<bool> holdsProject(const std::filesystem::path& file);

/// Whether another program has unfinished writes to the database: its journal lies beside the file.
bool isBeingWritten(const std::filesystem::path& database);

}  // namespace noonmark
