#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
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

}  // namespace noonmark
