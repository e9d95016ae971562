#pragma once

#include <string>
#include <variant>
#include <vector>

namespace noonmark::bench {

/// A number, a word, or nothing: a value that was not measured is empty, never zero.
using TableCell = std::variant<std::monostate, double, std::string>;

/// The result of an experiment for further use: one row per measurement.
struct Table {
    std::vector<std::string> columns;          ///< lower case, unit at the end: "time_s"
    std::vector<std::vector<TableCell>> rows;  ///< each as long as `columns`
};

/// RFC 4180, lines end in \n, decimal points, a header row with the column names. Numbers have enough digits
/// to be read back exactly.
std::string toCsv(const Table& table);

}  // namespace noonmark::bench
