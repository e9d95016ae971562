#pragma once

#include <map>
#include <string>

namespace noonmark {

/// Named texts that a file carries in addition to its values: metadata items of a GeoTIFF, text chunks of a
/// PNG. Names: capital letters, digits and underscores. Texts: UTF-8.
using FileTags = std::map<std::string, std::string>;

}  // namespace noonmark
