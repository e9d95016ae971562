#include "core/base/csv_field.h"

#include <algorithm>
#include <string_view>

namespace noonmark {

namespace {

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

}  // namespace

std::string disarmFormula(const std::string& text) {
    if (text.empty()) return text;
    const bool begins = std::string_view("=@\t\r\n").find(text.front()) != std::string_view::npos;
    const bool isSigned = text.front() == '+' || text.front() == '-';
    return begins || (isSigned && !isAmount(std::string_view(text).substr(1))) ? "'" + text : text;
}

std::string quoteField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + '"';
}

std::string csvField(const std::string& text) { return quoteField(disarmFormula(text)); }

}  // namespace noonmark
