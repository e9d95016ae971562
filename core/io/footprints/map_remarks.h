#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// What a remark of GDAL's vector readers means for the city, in a planner's words: the text of a warning.
/// Empty where nothing happened to the data; the remark itself where it is not known.
std::string makeMapRemark(std::string_view words);

}  // namespace noonmark
