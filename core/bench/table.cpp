#include "core/bench/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace noonmark::bench {

namespace {

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string inside;
    for (const char letter : text) inside.append(letter == '"' ? 2 : 1, letter);
    return fmt::format("\"{}\"", inside);
}

std::string formatText(const TableCell& cell) {
    if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{}", *number);
    if (const auto* text = std::get_if<std::string>(&cell)) return quoted(*text);
    return {};
}

}  // namespace

std::string toCsv(const Table& table) {
    std::string csv = fmt::format("{}\n", fmt::join(table.columns, ","));
    for (const auto& row : table.rows) {
        std::vector<std::string> cells;
        for (const TableCell& cell : row) cells.push_back(formatText(cell));
        csv += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return csv;
}

}  // namespace noonmark::bench
