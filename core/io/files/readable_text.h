#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// Text of unknown encoding as UTF-8: unchanged where it is UTF-8, else read as Windows-1252, the usual
/// encoding of tables that state none (a Shapefile without .cpg). O(bytes).
std::string readableText(std::string_view bytes);

/// The code point at `at` of UTF-8 text; advances `at` past it, or by one byte, returning U+FFFD, if the
/// bytes are not UTF-8.
char32_t nextCodePoint(std::string_view text, std::size_t& at);

void appendUtf8(std::string& text, char32_t point);

}  // namespace noonmark
