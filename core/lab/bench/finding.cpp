#include "core/lab/bench/finding.h"

#include "core/base/csv_text.h"

namespace noonmark::bench {

namespace {

void addCell(CsvText& csv, const TableCell& cell) {
    if (const auto* number = std::get_if<double>(&cell))
        csv.number(*number);
    else if (const auto* text = std::get_if<std::string>(&cell))
        csv.text(*text);
    else
        csv.nothing();
}

}  // namespace

std::string toCsv(const Table& table) {
    CsvText csv({table.columns.begin(), table.columns.end()});
    for (const auto& row : table.rows) {
        for (const TableCell& cell : row) addCell(csv, cell);
        csv.endRow();
    }
    return csv.take();
}

}  // namespace noonmark::bench
