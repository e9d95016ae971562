#pragma once

#include <string_view>

namespace noonmark::tests {

/// Ends the program with these words where what every reader promises does not hold: a finding like a crash.
void require(bool holds, std::string_view words);

}  // namespace noonmark::tests
