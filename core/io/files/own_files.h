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
/// outlive the connection. Backend: own_files_sqlite.cpp.
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

}  // namespace noonmark
