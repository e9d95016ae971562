#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace noonmark {

/// Parses the `other_tags` column that converters of OpenStreetMap data write:
/// "height"=>"12","roof:shape"=>"flat"; inside the quotes a backslash escapes the next character. The list
/// ends at the first syntax error.
std::vector<std::pair<std::string, std::string>> parseTags(std::string_view text);

}  // namespace noonmark
