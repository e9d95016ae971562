#pragma once

// The folder core/study/verification checks a result that somebody filed: ResultRecord (this file) is the
// JSON that stands beside a report or is attached to it, find_inputs.h looks for the files it was made from,
// compare_records.h compares it with a record of today's run, compare_words.h what the pages print. The
// command line `noonmark-cli verify` runs the recorded command in between.

#include <filesystem>
#include <nlohmann/json.hpp>
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

}  // namespace noonmark
