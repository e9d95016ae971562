#pragma once

#include <filesystem>
#include <memory>

#include "core/base/result.h"

namespace noonmark {

/// Checks what lies beside an untrusted SQLite database and acts on it when it is opened: `-journal`, `-wal`
/// and `-shm`. Error: one of them is a link, a pipe or a device; or the journal belongs to a transaction over
/// several databases and names a file that SQLite would delete, or it states that the database was longer
/// than database and journal together. Reads some bytes and writes nothing.
Result<void> checkBeside(const std::filesystem::path& database);

/// The most bytes that a value of an SQLite database can have, for SQLITE_LIMIT_LENGTH: those of its file and
/// journal (at least 1 MB, at most SQLite's own limit of 1 GB). A longer one was made by SQL of the file.
int longestValue(const std::filesystem::path& database);

/// Lets one connection of SQLite reach only its own database, the journals of that and SQLite's temporary
/// files: any other file is neither looked for nor opened nor deleted, whatever a journal names. It must
/// outlive the connection. Backend: geopackage_check_sqlite.cpp.
class OwnFiles {
public:
    OwnFiles();
    ~OwnFiles();
    OwnFiles(const OwnFiles&) = delete;
    OwnFiles& operator=(const OwnFiles&) = delete;

    /// For the last parameter of sqlite3_open_v2().
    [[nodiscard]] const char* name() const;

private:
    struct Access;
    std::unique_ptr<Access> access_;
};

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
