#include "app/cli/base/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "core/base/clean_text.h"
#include "core/base/units.h"

namespace noonmark::cli {

void Table::print(std::ostream& out) const {
    std::size_t width = 0;
    for (const auto& [label, value] : rows_) width = std::max(width, label.size());
    for (const auto& [label, value] : rows_)
        out << fmt::format("{:<{}}  {}\n", cleanText(label), width, cleanText(value));
}

namespace {

// Terminals may know ASCII only.
std::string plainUnits(std::string text) {
    constexpr std::string_view square = "m²";
    for (std::size_t at = text.find(square); at != std::string::npos; at = text.find(square, at))
        text.replace(at, square.size(), "m2");
    return text;
}

}  // namespace

void addFigures(Table& table, const std::vector<FigureLine>& lines) {
    for (const FigureLine& line : lines)
        table.add(plainUnits(lowered(labelOf(line))), plainUnits(valueOf(line)));
}

void addFigures(Table& table, std::string label, const std::vector<FigureLine>& lines) {
    table.add(std::move(label), plainUnits(joinLines(lines)));
}

void addErrors(Table& table, std::span<const ShownError> errors) {
    for (const ShownError& error : errors)
        table.add("error: " + lowered(labelOf(error)), plainUnits(formatText(describe(error))));
}

std::string withCommas(std::size_t number) { return formatNumber(double(number)); }

void printWarnings(std::ostream& out, const Warnings& warnings) {
    if (warnings.empty()) return;
    out << "\n"
           "Warnings (--json lists all of them)\n";
    for (const WarningGroup& group : groupWarnings(warnings)) out << "  " << lineOf(group) << '\n';
}

}  // namespace noonmark::cli
