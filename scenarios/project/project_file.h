#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/project/project.h"

namespace noonmark {

/// File name ending of project files.
inline constexpr const char* projectEnding = ".noonmark.gpkg";

/// A project file NAME.noonmark.gpkg on disk, with its content as last read or saved. It is a GeoPackage
/// (docs/project-file.md). No file handle stays open between calls. A value; not safe for concurrent use.
///
/// Every save is one SQLite transaction with a rollback journal and synchronous = FULL: after a crash at any
/// moment the file holds the last completed save, or the new one if the crash came at the very end. A file
/// that is damaged, newer than the program, locked, read-only, or saved by another program since it was read
/// gives an Error and is not changed.
class ProjectFile {
public:
    enum class IfExists { refuse, replace };

    /// Writes a new file under a temporary name in the same folder and renames it. Error: the file exists
    /// (refuse), or the project is invalid. About half a second for 43,000 buildings.
    static Result<ProjectFile> create(const std::filesystem::path& file, const Project& project,
                                      IfExists ifThere = IfExists::refuse);

    /// Reads the whole file. An older schema version is migrated in memory; the next save migrates the file.
    static Result<ProjectFile> open(const std::filesystem::path& file);

    /// Writes the differences from project(); the cost depends on their size. On an Error the file stays
    /// unchanged.
    Result<void> save(const Project& project);

    /// Whether the file still holds project(), that is, no other program has saved it since. False where it
    /// cannot be read.
    [[nodiscard]] bool isUnchanged() const;

    [[nodiscard]] const Project& project() const { return project_; }  ///< as on disk
    /// The city of project() with what the file refers to and does not hold, such as the pixels of a picture
    /// of the ground. Not null; the same buildings. It is not written.
    void setCityWithPictures(std::shared_ptr<const City> city) { project_.city = std::move(city); }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::int64_t saves() const { return saves_; }  ///< number of saves so far, at least 1
    [[nodiscard]] const std::string& id() const {
        return id_;
    }  ///< of the project; copies of the file share it

private:
    std::filesystem::path path_;
    Project project_;
    std::string id_;
    std::int64_t saves_ = 0;
};

/// The recovery file of a project file: a hidden project file beside it.
std::filesystem::path recoveryPath(const std::filesystem::path& file);

/// Remove or rename a project file that this program wrote together with the journal that a killed save left
/// beside it. A journal that stayed behind would be applied to the next file of that name. Failures are
/// ignored.
void removeProject(const std::filesystem::path& file);
void moveProject(const std::filesystem::path& from, const std::filesystem::path& to);

/// Saves unsaved work to the recovery file: the whole project at first, then only changes.
class Autosave {
public:
    explicit Autosave(const std::filesystem::path& file) : path_(recoveryPath(file)) {}

    Result<void> keep(const Project& project);
    /// Deletes the recovery file, after a save or when the user discards the work.
    void discard();

private:
    std::filesystem::path path_;
    std::optional<ProjectFile> saved_;
};

/// A recovery file that an earlier run left behind.
struct Recovery {
    std::filesystem::path path;
    std::filesystem::file_time_type at;  ///< when it was written
};

/// Empty where there is no recovery file, or where the project file was saved after it.
std::optional<Recovery> recoveryOf(const std::filesystem::path& file);

}  // namespace noonmark
