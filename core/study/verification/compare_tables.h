#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/verification/compare_records.h"

namespace noonmark {

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

}  // namespace noonmark
