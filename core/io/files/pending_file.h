#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace noonmark {

/// A file in the making. It is written at path(), a hidden name beside the target, and takes the target's
/// name in one step when it is whole: who looks at the target sees the old file or the new one, never half of
/// one.
class PendingFile {
public:
    explicit PendingFile(std::filesystem::path target);
    /// Removes what was not committed.
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Where to write. In the target's folder, with the target's extension, different for every PendingFile
    /// of every process.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Renames path() to the target, replacing what is there. Close the file first. Error when the folder
    /// does not allow it.
    Result<void> commit();

private:
    std::filesystem::path target_;
    std::filesystem::path path_;
};

}  // namespace noonmark
