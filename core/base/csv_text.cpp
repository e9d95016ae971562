#include "core/base/csv_text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/safe_text.h"

namespace noonmark {

namespace {

using Texts = std::span<const std::string_view>;

// Blanks that a spreadsheet may skip: also the no-break, the ideographic and the zero-width one, and the byte
// order mark.
constexpr std::array<std::string_view, 5> blanks{" ", "\u00A0", "\u3000", "\u200B", "\uFEFF"};
// Each as itself, full-width and small; "-" also as the sign of mathematics.
constexpr std::array<std::string_view, 6> formulaSigns{"=", "\uFF1D", "\uFE66", "@", "\uFF20", "\uFE6B"};
constexpr std::array<std::string_view, 7> amountSigns{"+",      "\uFF0B", "\uFE62", "-",
                                                      "\uFF0D", "\uFE63", "\u2212"};

bool isLetterOrDigit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0;
}

// "5", "0.5", "5 m2": after its sign a spreadsheet takes it for a number or for text, and computes nothing.
bool isAmount(std::string_view text) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789.,"), text.size());
    if (digits == 0) return false;
    const std::string_view unit = text.substr(digits);
    return unit.empty() || (unit.front() == ' ' && std::ranges::all_of(unit.substr(1), isLetterOrDigit));
}

// Removes the first of the beginnings that the text has.
bool removeOne(std::string_view& text, Texts beginnings) {
    const auto found =
        std::ranges::find_if(beginnings, [&](std::string_view one) { return text.starts_with(one); });
    if (found == beginnings.end()) return false;
    text.remove_prefix(found->size());
    return true;
}

bool isFormula(std::string_view text) {
    while (removeOne(text, blanks)) continue;
    if (text.empty()) return false;
    if (std::string_view("\t\r\n").find(text.front()) != std::string_view::npos) return true;
    return removeOne(text, formulaSigns) || (removeOne(text, amountSigns) && !isAmount(text));
}

// Apostrophes of its own count as part of a formula: so that each text has a disarmed one of its own.
bool needsApostrophe(std::string_view text) {
    return isFormula(text.substr(std::min(text.find_first_not_of('\''), text.size())));
}

}  // namespace

std::string escapeFormula(const std::string& text) { return needsApostrophe(text) ? "'" + text : text; }

std::string unescapeFormula(const std::string& text) {
    return text.starts_with('\'') && needsApostrophe(text) ? text.substr(1) : text;
}

std::string quoteField(std::string_view text) {
    if (text.find_first_of(",;\t\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char letter : text) quoted.append(letter == '"' ? 2 : 1, letter);
    return quoted + '"';
}

std::string csvField(const std::string& text) { return quoteField(escapeFormula(text)); }

namespace {

char separatorOf(std::string_view text) {
    const std::string_view heading = text.substr(0, text.find_first_of("\r\n"));
    const bool semicolons = heading.find(';') != std::string_view::npos;
    return semicolons && heading.find(',') == std::string_view::npos ? ';' : ',';
}

class Rows {
public:
    void letter(char one) { field_ += one; }
    void quote() { quoted_ = true; }
    void lineEnds() { ++line_; }
    void endField() {
        row_.fields.push_back(unescapeFormula(quoted_ ? std::move(field_) : trimmed(field_)));
        field_.clear();
        quoted_ = false;
    }
    void endRow() {
        const bool empty = row_.fields.empty() && !quoted_ && trimmed(field_).empty();
        endField();
        if (!empty) rows_.push_back(std::move(row_));
        row_ = {line_, {}};
    }
    std::vector<CsvRow> take() && { return std::move(rows_); }

private:
    std::vector<CsvRow> rows_;
    CsvRow row_;
    std::size_t line_ = 1;
    std::string field_;
    bool quoted_ = false;
};

}  // namespace

std::vector<CsvRow> parseCsvRows(std::string_view text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
    const char separator = separatorOf(text);
    Rows rows;
    bool inQuotes = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        // Of a carriage return and a line feed only the line feed ends the line.
        if (text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n")) rows.lineEnds();
        if (text[i] == '"' && inQuotes && i + 1 < text.size() && text[i + 1] == '"')
            rows.letter(text[i++]);
        else if (text[i] == '"') {
            inQuotes = !inQuotes;
            rows.quote();
        } else if (inQuotes || (text[i] != separator && text[i] != '\n' && text[i] != '\r'))
            rows.letter(text[i]);
        else if (text[i] == separator)
            rows.endField();
        else
            rows.endRow();
    }
    rows.endRow();
    return std::move(rows).take();
}

namespace {

constexpr std::size_t maxDigits = 400;  // the largest double has 309 before its point

// What rounds to zero has no sign.
std::string_view withoutSignOfZero(std::string_view number) {
    const bool isZero = number.find_first_not_of("-0.") == std::string_view::npos;
    return isZero && number.starts_with('-') ? number.substr(1) : number;
}

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
    return field(withoutSignOfZero({digits.begin(), end.ptr}));
}

CsvText& CsvText::number(double value) {
    if (!std::isfinite(value)) return nothing();
    std::array<char, maxDigits> digits{};
    return field(withoutSignOfZero({digits.begin(), std::to_chars(digits.begin(), digits.end(), value).ptr}));
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
