#pragma once

#include <filesystem>

#include "core/base/private_folder.h"
#include "core/base/result.h"

namespace noonmark {

/// An output file that is being written. It is written at path(), under the target's name in a private folder
/// beside it (PrivateFolder), and takes the target's place in one step when it is complete, so that readers
/// of the target see the old file or the new one, never a part.
class PendingFile {
public:
    explicit PendingFile(std::filesystem::path target);
    /// Removes the file if it was not committed.
    ~PendingFile() = default;
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    /// Path to write to: on the target's disk, with the target's name.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Moves path() to the target, replacing an existing file. Close the file first. Error if the folder
    /// does not allow it.
    Result<void> commit();

private:
    std::filesystem::path target_;
    PrivateFolder folder_;
    std::filesystem::path path_;
};

}  // namespace noonmark
