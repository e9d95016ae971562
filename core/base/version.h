#pragma once

#include <string_view>

namespace noonmark {

/// "0.1.0": of the program that made a result.
std::string_view version();

}  // namespace noonmark
