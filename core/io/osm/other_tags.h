#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace noonmark {

/// The tags in the `other_tags` column that converters of OpenStreetMap data write:
/// "height"=>"12","roof:shape"=>"flat"; inside the quotes a backslash keeps the next letter. What cannot be
/// read ends the list.
std::vector<std::pair<std::string, std::string>> parseTags(std::string_view text);

}  // namespace noonmark
