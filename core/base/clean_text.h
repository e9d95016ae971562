#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace noonmark {

/// Words from a stranger's file as one line that is safe to show: control characters, line breaks and marks
/// that turn the direction of writing become blanks, bytes that are not UTF-8 become '?'. At most so many
/// characters are kept.
std::string cleanText(std::string_view text, std::size_t maxLetters = std::string_view::npos);

/// As cleanText(), of a text that may have several lines: tabs and line ends ("\n", "\r\n") stay.
std::string cleanLines(std::string_view text);

}  // namespace noonmark
