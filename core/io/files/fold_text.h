#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// UTF-8 as people type it, folded to what a parser of numbers and units compares: lower case ASCII,
/// full-width forms made narrow, typographic quotes and primes made ' and ", every kind of blank made a blank
/// and those at the ends cut off. What has no such form, and every byte that is not UTF-8, becomes one '?'.
/// Never throws but for lack of memory; O(bytes).
std::string foldText(std::string_view utf8);

}  // namespace noonmark
