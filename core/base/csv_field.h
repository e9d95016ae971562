#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// The text, with an apostrophe in front where a spreadsheet would run it as a formula: names in city files
/// come from strangers. Signs count in their full-width and small forms, too, and behind blanks. Of texts
/// that begin with a plus or minus only amounts stay: "-5", "+0.5", "-5 m2".
std::string disarmFormula(const std::string& text);
/// The text that disarmFormula() was given.
std::string restoreFormula(const std::string& text);

/// A text as a field of a CSV file, quoted if a reader would split it (RFC 4180; a semicolon or a tab
/// separates the fields where a decimal comma is usual).
std::string quoteField(std::string_view text);
/// As quoteField(), of the disarmed text.
std::string csvField(const std::string& text);

}  // namespace noonmark
