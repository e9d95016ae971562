#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scenarios/project/project_file.h"

namespace noonmark {

/// Where the unsaved work of a project file is kept: a hidden project file beside it.
std::filesystem::path recoveryPath(const std::filesystem::path& file);

/// Keeps unsaved work. The first time it writes a whole file, then what changed.
class Autosave {
public:
    explicit Autosave(const std::filesystem::path& file) : path_(recoveryPath(file)) {}

    Result<void> keep(const Project& project);
    /// After a save, or when the user discards the work.
    void discard();

private:
    std::filesystem::path path_;
    std::optional<ProjectFile> saved_;
};

/// Work that was not saved when the program ended.
struct Recovery {
    std::filesystem::path path;
    std::filesystem::file_time_type at;  ///< when it was kept
};

/// Nothing where there is none, or where the file was saved later than it.
std::optional<Recovery> recoveryOf(const std::filesystem::path& file);

}  // namespace noonmark
