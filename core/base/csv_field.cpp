#include "core/base/csv_field.h"

#include <algorithm>
#include <array>
#include <span>

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

std::string disarmFormula(const std::string& text) { return needsApostrophe(text) ? "'" + text : text; }

std::string restoreFormula(const std::string& text) {
    return text.starts_with('\'') && needsApostrophe(text) ? text.substr(1) : text;
}

std::string quoteField(std::string_view text) {
    if (text.find_first_of(",;\t\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char letter : text) quoted.append(letter == '"' ? 2 : 1, letter);
    return quoted + '"';
}

std::string csvField(const std::string& text) { return quoteField(disarmFormula(text)); }

}  // namespace noonmark
