#pragma once

#include <string>

namespace noonmark {

/// The text, with an apostrophe in front where a spreadsheet would run it as a formula: names in city files
/// come from strangers. Of texts that begin with a sign only amounts stay: "-5", "+0.5", "-5 m2".
std::string disarmFormula(const std::string& text);

/// A text as a field of a CSV file, quoted if needed (RFC 4180).
std::string quoteField(const std::string& text);
/// As quoteField(), of the disarmed text: for tables that people open, and no program reads back.
std::string csvField(const std::string& text);

}  // namespace noonmark
