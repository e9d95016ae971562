#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/base/console.h"
#include "core/base/private_folder.h"
#include "core/base/result.h"
#include "core/study/verification/find_inputs.h"

namespace noonmark::cli {

/// A folder in which a recorded command runs: it holds only the files that the record names, under their
/// recorded names, and what the command writes. Removed at the end.
class RepeatFolder {
public:
    /// Error: the folder cannot be made, or two recorded files have the same name.
    static Result<RepeatFolder> make(const std::vector<FoundFile>& files);
    /// Adds a file under its own name. Files that are there already stay.
    [[nodiscard]] Result<void> add(const std::filesystem::path& file) const;
    /// Runs the words of a noonmark-cli command in the folder. Error: it failed, with what it said, or
    /// cancelled().
    [[nodiscard]] Result<void> run(const std::vector<std::string>& words, const Console& console) const;
    [[nodiscard]] std::filesystem::path outputs() const { return folder_.path() / "repeated"; }

private:
    explicit RepeatFolder(PrivateFolder folder) : folder_(std::move(folder)) {}
    PrivateFolder folder_;
};

}  // namespace noonmark::cli
