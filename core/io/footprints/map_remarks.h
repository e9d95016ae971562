#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// Translates a message of GDAL's vector readers into a warning text that a planner understands. Empty if the
/// message does not concern the data; an unknown message is returned unchanged.
std::string makeMapRemark(std::string_view words);

}  // namespace noonmark
