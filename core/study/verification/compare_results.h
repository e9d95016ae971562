#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

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
/// and the command. Numbers agree within one part in 10^9, which covers another order of summation and is far
/// below what any report prints.
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
/// other programs would read its figures in the wrong columns.
TableComparison compareTables(const std::string& name, std::string_view recorded, std::string_view computed);

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
