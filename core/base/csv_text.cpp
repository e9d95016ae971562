#include "core/base/csv_text.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/base/csv_field.h"

namespace noonmark {

CsvText::CsvText(const std::vector<std::string>& columns) : columns_(columns.size()) {
    for (const std::string& column : columns) text(column);
    endRow();
}

CsvText& CsvText::text(const std::string& value) { return field(csvField(value)); }

CsvText& CsvText::number(double value, int decimals) {
    if (!std::isfinite(value)) return nothing();
    std::array<char, 400> digits{};  // the largest double has 309 digits before its point
    const auto written = fmt::format_to_n(digits.data(), digits.size(), "{:.{}f}", value, decimals);
    return field({digits.data(), written.size});
}

CsvText& CsvText::number(double value) {
    return std::isfinite(value) ? field(fmt::format("{}", value)) : nothing();
}

CsvText& CsvText::nothing(std::size_t fields) {
    for (std::size_t i = 0; i < fields; ++i) field({});
    return *this;
}

void CsvText::endRow() {
    assert(fields_ == columns_);
    text_ += "\r\n";
    fields_ = 0;
}

std::string CsvText::take() { return std::exchange(text_, {}); }

CsvText& CsvText::field(std::string_view written) {
    if (fields_++ > 0) text_ += ',';
    text_ += written;
    return *this;
}

}  // namespace noonmark
