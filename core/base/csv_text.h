#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

/// A table as CSV (RFC 4180), field by field: every table that leaves the program is written by it. Fields
/// are separated by commas, rows end with a carriage return and a line feed; texts are disarmed
/// (disarmFormula()) and quoted where needed; numbers have a decimal point and no separators.
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
