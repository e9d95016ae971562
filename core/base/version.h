#pragma once

#include <string_view>

namespace noonmark {

/// Version of this program: "0.1.0".
std::string_view version();

}  // namespace noonmark
