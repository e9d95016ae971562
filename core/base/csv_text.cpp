#include "core/base/csv_text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/base/csv_field.h"

namespace noonmark {

namespace {

constexpr std::size_t maxDigits = 400;  // the largest double has 309 before its point

}  // namespace

CsvText::CsvText(const std::vector<std::string>& columns) : columns_(columns.size()) {
    for (const std::string& column : columns) text(column);
    endRow();
}

CsvText& CsvText::text(const std::string& value) { return field(csvField(value)); }

CsvText& CsvText::number(double value, int decimals) {
    if (!std::isfinite(value)) return nothing();
    std::array<char, maxDigits> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), value, std::chars_format::fixed, decimals);
    return field({digits.begin(), end.ptr});
}

CsvText& CsvText::number(double value) {
    if (!std::isfinite(value)) return nothing();
    std::array<char, maxDigits> digits{};
    return field({digits.begin(), std::to_chars(digits.begin(), digits.end(), value).ptr});
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
