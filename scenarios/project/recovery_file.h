#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/project/project_file.h"

namespace noonmark {

/// The recovery file of a project file: a hidden project file beside it.
std::filesystem::path recoveryPath(const std::filesystem::path& file);

/// Remove or rename a project file that this program wrote together with the journal that a killed save left
/// beside it. A journal that stayed behind would be applied to the next file of that name. What cannot be
/// done is left.
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
