#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/study/verification/result_record.h"

namespace noonmark {

/// A recorded file, as it was looked for.
struct FoundFile {
    RecordedFile recorded;
    std::optional<std::filesystem::path> path;  ///< a file of that name; none: not found
    bool agrees = false;                        ///< its hash is the recorded one, or it is a sample
    bool isSavedAgain = false;  ///< another hash, but a project whose content the result rests on is the same
};

/// Looks for each recorded file by its name in a folder and its subfolders (100,000 entries at most); of
/// several of that name, for the one with the recorded hash. Reads the found files once.
std::vector<FoundFile> findInputs(const std::vector<RecordedFile>& files, const std::filesystem::path& folder,
                                  const std::stop_token& stop);

/// Whether all files that the command reads were found and agree.
bool areComplete(const std::vector<FoundFile>& files);

}  // namespace noonmark
