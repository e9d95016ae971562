#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/working_files.h"

namespace noonmark {

/// Named texts that a file carries in addition to its values: metadata items of a GeoTIFF, text chunks of a
/// PNG. Names: capital letters, digits and underscores. Texts: UTF-8.
using FileTags = std::map<std::string, std::string>;

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

/// Writes a text file completely or not at all: under a temporary name in the same folder, then renamed.
/// Error: the folder does not allow it, or the disk is full.
Result<void> writeText(const std::filesystem::path& file, std::string_view text);

}  // namespace noonmark
