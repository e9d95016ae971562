#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace noonmark {

/// Words from a stranger's file as one line that is safe to show: control characters, line breaks and marks
/// that turn the direction of writing become blanks, bytes that are not UTF-8 become '?'. At most so many
/// characters are kept.
std::string cleanText(std::string_view text, std::size_t maxLetters = std::string_view::npos);

/// As cleanText(), of a text that may have several lines: tabs and line ends ("\n", "\r\n") stay.
std::string cleanLines(std::string_view text);

/// Without blanks and line ends around it.
std::string trimmed(std::string_view text);

/// Of ASCII, in every locale.
constexpr bool isDigit(char letter) { return letter >= '0' && letter <= '9'; }

/// A number of things in a sentence: "1 tile", "1,204 tiles", "2 boxes" with their plural "boxes". `noun`:
/// one of them; `plural` where it is not the noun with an "s".
std::string countOf(std::uint64_t count, std::string_view noun, std::string_view plural = {});

/// A text as one word of a POSIX shell: unchanged if a shell cannot misread it, else in single quotes.
std::string quoteForShell(const std::string& text);

/// Text as the content of an XML element or of an attribute in double quotes. Control characters, which XML
/// does not allow, become spaces.
std::string escapeXml(std::string_view text);

}  // namespace noonmark
