#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// A text as one word of a POSIX shell: unchanged if a shell cannot misread it, else in single quotes.
std::string quoteForShell(const std::string& text);

/// Text as the content of an XML element or of an attribute in double quotes. Control characters, which XML
/// does not allow, become spaces.
std::string escapeXml(std::string_view text);

}  // namespace noonmark
