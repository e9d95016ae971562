#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/warnings.h"

namespace noonmark {

/// Translates a message of GDAL's vector readers into a warning text that a planner understands. Empty if the
/// message does not concern the data; an unknown message is returned unchanged.
std::string makeMapRemark(std::string_view words);

/// Adds these messages as warnings: GDAL does not name the feature that a message is about, so there is one
/// for each kind, with its count.
void addMapRemarks(const std::vector<std::string>& words, const std::string& file, Warnings& warnings);

}  // namespace noonmark
