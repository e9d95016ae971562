#include "core/study/verification/compare_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/base/csv_rows.h"

namespace noonmark {

namespace {

using RowFields = std::vector<std::string>;

std::optional<double> numberIn(const std::string& text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && rest == end ? std::optional(number) : std::nullopt;
}

bool agreeAsFields(const std::string& recorded, const std::string& computed) {
    if (recorded == computed) return true;
    const auto a = numberIn(recorded), b = numberIn(computed);
    return a && b && agree(*a, *b);
}

/// Compares row by row.
class TableReading {
public:
    TableReading(const std::string& name, const std::vector<CsvRow>& recorded,
                 const std::vector<CsvRow>& computed)
        : recorded_(recorded), computed_(computed) {
        result_.name = name;
    }

    TableComparison compare() && {
        for (std::size_t row = 0; row < std::max(recorded_.size(), computed_.size()); ++row) {
            if (row >= recorded_.size() || row >= computed_.size())
                differ(row, "", std::string(row < recorded_.size() ? "a row" : ""),
                       std::string(row < computed_.size() ? "a row" : ""));
            else
                compareRow(row, recorded_[row].fields, computed_[row].fields);
        }
        return std::move(result_);
    }

private:
    void compareRow(std::size_t row, const RowFields& recorded, const RowFields& computed) {
        const RowFields& heading = recorded_.front().fields;
        if (recorded.size() != heading.size())
            differ(row, "", fmt::format("{} fields", recorded.size()),
                   fmt::format("{} in the heading", heading.size()));
        else if (recorded.size() != computed.size())
            differ(row, "", fmt::format("{} fields", recorded.size()), fmt::format("{}", computed.size()));
        else
            for (std::size_t i = 0; i < recorded.size(); ++i) {
                ++result_.fields;
                if (!agreeAsFields(recorded[i], computed[i]))
                    differ(row, ", " + heading[i], recorded[i], computed[i]);
            }
    }

    void differ(std::size_t row, const std::string& column, std::string recorded, std::string computed) {
        const std::size_t line = row < recorded_.size() ? recorded_[row].line : computed_[row].line;
        result_.differences.push_back({fmt::format("{}, line {}{}", result_.name, line, column),
                                       std::move(recorded), std::move(computed)});
    }

    const std::vector<CsvRow>&recorded_, &computed_;
    TableComparison result_;
};

}  // namespace

TableComparison compareTables(const std::string& name, std::string_view recorded, std::string_view computed) {
    const auto before = parseCsvRows(recorded), after = parseCsvRows(computed);
    return TableReading(name, before, after).compare();
}

}  // namespace noonmark
