#include "app/cli/base/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "core/base/clean_text.h"
#include "core/base/display_units.h"

namespace noonmark::cli {

void Table::print(std::ostream& out) const {
    std::size_t width = 0;
    for (const auto& [label, value] : rows_) width = std::max(width, label.size());
    for (const auto& [label, value] : rows_)
        out << fmt::format("{:<{}}  {}\n", cleanText(label), width, cleanText(value));
}

void addWater(Table& table, double waterM2) {
    if (waterM2 > 0) table.add("water", fmt::format("{:.0f} m2 left out", waterM2));
}

std::string withCommas(std::size_t number) { return formatNumber(double(number)); }

void printWarnings(std::ostream& out, const Warnings& warnings) {
    if (warnings.empty()) return;
    out << "\n"
           "Warnings (--json lists all of them)\n";
    for (const WarningGroup& group : groupWarnings(warnings)) out << "  " << lineOf(group) << '\n';
}

}  // namespace noonmark::cli
