#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// Text as the content of an XML element or of an attribute in double quotes. Control characters, which XML
/// does not allow, become spaces.
std::string escapeXml(std::string_view text);

}  // namespace noonmark
