#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

/// The text, with an apostrophe in front where a spreadsheet would run it as a formula: names in city files
/// come from strangers. Signs count in their full-width and small forms, too, and behind blanks. Of texts
/// that begin with a plus or minus only amounts stay: "-5", "+0.5", "-5 m2".
std::string escapeFormula(const std::string& text);
/// The text that escapeFormula() was given.
std::string unescapeFormula(const std::string& text);

/// A text as a field of a CSV file, quoted if a reader would split it (RFC 4180; a semicolon or a tab
/// separates the fields where a decimal comma is usual).
std::string quoteField(std::string_view text);
/// As quoteField(), of the escaped text.
std::string csvField(const std::string& text);

struct CsvRow {
    std::size_t line = 1;  ///< of the text where the row begins
    std::vector<std::string> fields;
};

/// The non-empty rows of a CSV text (RFC 4180: quoted fields may contain commas, line ends and doubled
/// quotes). A heading with semicolons and no comma, as spreadsheets in many countries write it, makes the
/// semicolon the separator. A byte order mark and blanks around unquoted fields are skipped, and the
/// apostrophe that CsvText sets before a formula.
std::vector<CsvRow> parseCsvRows(std::string_view text);

/// A table as CSV (RFC 4180), field by field: every table that leaves the program is written by it. Fields
/// are separated by commas, rows end with a carriage return and a line feed; texts are escaped
/// (escapeFormula()) and quoted where needed; numbers have a decimal point and no separators.
class CsvText {
public:
    /// Writes the heading.
    explicit CsvText(const std::vector<std::string>& columns);

    CsvText& text(const std::string& value);
    /// With that many decimals; nothing for what is no number.
    CsvText& number(double value, int decimals);
    /// With as many digits as its value needs.
    CsvText& number(double value);
    CsvText& number(const std::optional<double>& value, int decimals) {
        return value ? number(*value, decimals) : nothing();
    }
    CsvText& whole(std::integral auto value) { return field(std::to_string(value)); }
    /// Empty fields.
    CsvText& nothing(std::size_t fields = 1);
    /// Ends the row, which must have as many fields as the heading.
    void endRow();

    /// What has been written since the last call.
    std::string take();
    [[nodiscard]] std::size_t size() const { return text_.size(); }

private:
    CsvText& field(std::string_view written);

    std::string text_;
    std::size_t columns_, fields_ = 0;
};

}  // namespace noonmark
