#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// Normalises UTF-8 text for parsers of numbers and units: ASCII in lower case, full-width forms as ASCII,
/// typographic quotes and primes as ' and ", every kind of blank as a space, blanks at both ends removed. Any
/// other character, and every byte that is not UTF-8, becomes one '?'. Never throws except for lack of
/// memory; O(bytes).
std::string foldText(std::string_view utf8);

}  // namespace noonmark
