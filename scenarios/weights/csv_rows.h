#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

struct CsvRow {
    std::size_t line = 1;  ///< of the text, on which it begins
    std::vector<std::string> fields;
};

/// The rows of a CSV text (RFC 4180: quoted fields hold commas, line ends and doubled quotes), without empty
/// ones. Where the heading has semicolons and no comma, as spreadsheets of many countries write it, those
/// part the fields. A byte order mark is passed over; blanks around fields that are not quoted too.
std::vector<CsvRow> parseCsvRows(std::string_view text);

}  // namespace noonmark
