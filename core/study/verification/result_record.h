#pragma once

// The folder core/study/verification checks a result that somebody filed. ResultRecord (this file) is the
// JSON that stands beside a report or is attached to it; this file also looks for the files that the result
// was made from. compare_results.h compares the record with that of today's run, and the words and tables
// that both print. The command line `noonmark-cli verify` runs the recorded command in between.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace noonmark {

/// A file that a record names, with the hash it had.
struct RecordedFile {
    std::string path;    ///< as recorded: a path of another computer
    std::string sha256;  ///< lower-case hex; empty for a sample, which is generated
    /// Whether the command reads it; the files of a saved project's city are not read again.
    bool needed = true;
};

/// What a result states about itself. Comes from strangers: everything is checked, nothing is run here.
struct ResultRecord {  // NOLINT(bugprone-exception-escape): moving JSON throws nothing
    nlohmann::ordered_json json;
    std::vector<std::string> command;  ///< its words, from the program's name on
    std::vector<RecordedFile> files;
};

/// Commands of noonmark-cli that file results and may be run again: "study".
using Commands = std::vector<std::string_view>;

/// Reads the record of a result, such as study.json. Error: no JSON object, no command that repeats the
/// result (the record's own reason is stated), or a command that verification does not run: one that is not
/// among `known`, that names a file outside its folder, that saves into a project, or that writes elsewhere
/// than into `repeated`.
Result<ResultRecord> parseResultRecord(const std::string& text, const Commands& known,
                                       const std::string& where);

/// Largest record that is read, bytes.
inline constexpr std::uintmax_t maxBytesOfRecord = std::uintmax_t{256} << 20U;

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
