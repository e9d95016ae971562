#pragma once

// The folder core/study/verification checks a result that somebody filed. ResultRecord (this file) is the
// JSON that stands beside a report or is attached to it; this file also looks for the files that the result
// was made from. compare_results.cpp compares the record with that of today's run, and the words and tables
// that both print. The command line `noonmark-cli verify` runs the recorded command in between.

#include <cstddef>
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

/// Looks for those that no folder had with the recorded hash in another folder, without its subfolders.
void findInputsBeside(std::vector<FoundFile>& files, const std::filesystem::path& folder);

/// Whether all files that the command reads were found and agree.
bool areComplete(const std::vector<FoundFile>& files);

/// A figure or text that two records state differently.
struct RecordDifference {
    std::string key;       ///< "places[0].rows[2].enters"
    std::string recorded;  ///< as JSON; empty: not stated
    std::string computed;
};

struct RecordComparison {
    std::size_t compared = 0;                   ///< figures and texts that both state
    std::vector<RecordDifference> differences;  ///< in the order of the recorded ones
};

/// Compares the figures and texts of two records. Not compared is what another run or computer may state
/// otherwise: durations, what was skipped, the program's version, instruction set, how the engine was chosen,
/// and the command; nor what buildings take from single places, which the window attributes on a click and
/// no command computes, and verdicts counted beside scenarios, of which the review has a record. Numbers
/// agree within one part in 10^9, which covers another order of summation and is far below what any report
/// prints.
RecordComparison compareRecords(const nlohmann::ordered_json& recorded,
                                const nlohmann::ordered_json& computed);

/// Whether two numbers agree within that.
bool agree(double recorded, double computed);

/// What two CSV tables of the same name state.
struct TableComparison {
    std::string name;                           ///< "review.csv"
    std::size_t fields = 0;                     ///< that both have
    std::vector<RecordDifference> differences;  ///< by "review.csv, line 2, max_area_m2"
};

/// Reads both tables as a stranger's program does (RFC 4180, commas) and compares them field by field;
/// numbers agree as in compareRecords(). A row with more or fewer fields than the heading is a difference:
/// other programs would read its figures in the wrong columns. `leftOut`: columns that are not compared.
TableComparison compareTables(const std::string& name, std::string_view recorded, std::string_view computed,
                              const std::vector<std::string>& leftOut = {});

/// A passage that two texts print differently.
struct WordDifference {
    std::string before;    ///< the words that precede it in both
    std::string recorded;  ///< empty: nothing
    std::string computed;
    bool hasFigure = false;  ///< a word with a digit is among them
};

struct WordComparison {
    std::size_t figures = 0;  ///< words with a digit in the recorded text
    std::vector<WordDifference> differences;
};

/// Compares the words of two printed texts, in order. Passages are matched again where three words agree,
/// after at most 400 words. How long a computation took ("0.1 s in total") is not compared. Cost: linear in
/// texts that agree.
WordComparison compareWords(const std::string& recorded, const std::string& computed);

}  // namespace noonmark
