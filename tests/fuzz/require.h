#pragma once

#include <string_view>

namespace noonmark::tests {

/// Ends the program with this message if `holds` is false, that is, a reader broke a promise. The fuzzer
/// reports that like a crash.
void require(bool holds, std::string_view words);

}  // namespace noonmark::tests
