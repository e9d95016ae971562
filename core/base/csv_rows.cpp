#include "core/base/csv_rows.h"

#include <utility>

#include "core/base/csv_field.h"

namespace noonmark {

namespace {

char separatorOf(std::string_view text) {
    const std::string_view heading = text.substr(0, text.find_first_of("\r\n"));
    const bool semicolons = heading.find(';') != std::string_view::npos;
    return semicolons && heading.find(',') == std::string_view::npos ? ';' : ',';
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

class Rows {
public:
    void letter(char one) { field_ += one; }
    void quote() { quoted_ = true; }
    void lineEnds() { ++line_; }
    void endField() {
        row_.fields.push_back(restoreFormula(quoted_ ? std::move(field_) : trimmed(field_)));
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

}  // namespace noonmark
