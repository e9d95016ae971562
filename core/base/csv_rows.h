#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

struct CsvRow {
    std::size_t line = 1;  ///< of the text where the row begins
    std::vector<std::string> fields;
};

/// The non-empty rows of a CSV text (RFC 4180: quoted fields may contain commas, line ends and doubled
/// quotes). A heading with semicolons and no comma, as spreadsheets in many countries write it, makes the
/// semicolon the separator. A byte order mark and blanks around unquoted fields are skipped, and the
/// apostrophe that CsvText sets before a formula.
std::vector<CsvRow> parseCsvRows(std::string_view text);

}  // namespace noonmark
