#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace noonmark {

/// fillIn() with a text that is marked by NM_TEXT, in the language of the WordingScope around the call
/// (core/base/wording.h): "%1" to "%9" stand for the values.
std::string fillText(std::string_view english, std::initializer_list<std::string> values);

}  // namespace noonmark
