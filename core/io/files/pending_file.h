#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// An output file that is being written. It is written at path(), a hidden name beside the target, and takes
/// the target's name in one step when it is complete, so that readers of the target see the old file or the
/// new one, never a part.
class PendingFile {
public:
    explicit PendingFile(std::filesystem::path target);
    /// Removes the file if it was not committed.
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Path to write to: in the target's folder, with the target's extension, unique for every PendingFile of
    /// every process.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Renames path() to the target, replacing an existing file. Close the file first. Error if the folder
    /// does not allow it.
    Result<void> commit();

private:
    std::filesystem::path target_;
    std::filesystem::path path_;
};

}  // namespace noonmark
