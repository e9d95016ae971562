#pragma once

#include <string>
#include <variant>
#include <vector>

namespace noonmark::bench {

/// A number, a word, or nothing: what was not measured stays empty, it is never zero.
using TableCell = std::variant<std::monostate, double, std::string>;

/// The result of an experiment as others will read it: one line a measurement.
struct Table {
    std::vector<std::string> columns;          ///< lower case, unit at the end: "time_s"
    std::vector<std::vector<TableCell>> rows;  ///< each as long as `columns`
};

/// RFC 4180, lines ended by \n, a full stop in numbers, the columns' names first. Numbers have the digits
/// that bring them back exactly.
std::string toCsv(const Table& table);

}  // namespace noonmark::bench
