#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/project/project.h"

namespace noonmark {

/// The ending that project files have.
inline constexpr const char* projectEnding = ".noonmark.gpkg";

/// A project file NAME.noonmark.gpkg on the disk, and what was last read from it or saved to it. A GeoPackage
/// (docs/project-file.md). No handle is kept open between calls. A value; not for two threads at once.
///
/// Every save is one transaction of SQLite with a rollback journal, synchronous = FULL: a process that is
/// killed at any moment leaves the last save that ended, or (killed in the last instant) the new one. A file
/// that is damaged, newer than the program, locked, read-only, or was saved by someone else since, gives an
/// Error and stays as it is.
class ProjectFile {
public:
    enum class IfThere { refuse, replace };

    /// Writes a new file beside its place and renames it there. Error: it is there already (refuse), or a
    /// project that is not sound. 43,000 buildings take about half a second.
    static Result<ProjectFile> create(const std::filesystem::path& file, const Project& project,
                                      IfThere ifThere = IfThere::refuse);

    /// Reads all of it. A file of an older schema version is brought to this one in memory, and on the disk
    /// with the next save.
    static Result<ProjectFile> open(const std::filesystem::path& file);

    /// Writes what differs from project(), by the size of the difference. On an Error the file is as it was.
    Result<void> save(const Project& project);

    /// Whether the file still holds project(): nobody else has saved it since. False where it cannot be read.
    [[nodiscard]] bool isUnchanged() const;

    [[nodiscard]] const Project& project() const { return project_; }  ///< as it is on the disk
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::int64_t saves() const { return saves_; }  ///< how often it was saved, from 1
    [[nodiscard]] const std::string& id() const { return id_; }  ///< of the project, the same in its copies

private:
    std::filesystem::path path_;
    Project project_;
    std::string id_;
    std::int64_t saves_ = 0;
};

}  // namespace noonmark
