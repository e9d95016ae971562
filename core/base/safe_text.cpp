#include "core/base/safe_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace noonmark {

namespace {

// Bytes of the UTF-8 character at the front of the text; 0 where there is none.
std::size_t characterBytes(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (bytes == 0 || lead > 0xF4 || text.size() < bytes) return 0;
    for (std::size_t i = 1; i < bytes; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) return 0;
    if (bytes < 3) return bytes;
    const auto second = static_cast<unsigned char>(text[1]);
    const bool tooLong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool noCharacter = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
    return tooLong || noCharacter ? 0 : bytes;
}

bool isPlain(char c) { return c >= 0x20 && c < 0x7F; }

// One UTF-8 character that moves the cursor, begins a command of a terminal, ends a line (U+0000 to U+001F,
// U+007F to U+009F, U+2028, U+2029) or turns the direction of what follows (U+202A to U+202E, U+2066 to
// U+2069).
bool isControl(std::string_view character) {
    if (character.size() == 1) return !isPlain(character.front());
    if (character.size() == 2) return character >= "\u0080" && character <= "\u009F";
    return (character >= "\u2028" && character <= "\u202E") ||
           (character >= "\u2066" && character <= "\u2069");
}

// Moves the character at the front of the text to `clean`.
void takeCharacter(std::string_view& text, std::string& clean) {
    const std::size_t bytes = characterBytes(text);
    if (bytes == 0)
        clean += '?';
    else if (isControl(text.substr(0, bytes)))
        clean += ' ';
    else
        clean += text.substr(0, bytes);
    text.remove_prefix(std::max<std::size_t>(1, bytes));
}

}  // namespace

std::string cleanText(std::string_view text, std::size_t maxLetters) {
    if (text.size() <= maxLetters && std::ranges::all_of(text, isPlain)) return std::string(text);
    std::string clean;
    for (std::size_t letters = 0; !text.empty() && letters < maxLetters; ++letters)
        takeCharacter(text, clean);
    return clean;
}

std::string cleanLines(std::string_view text) {
    std::string clean;
    while (!text.empty()) {
        const std::size_t kept =
            text.front() == '\n' || text.front() == '\t' ? 1 : 2 * text.starts_with("\r\n");
        clean += text.substr(0, kept);
        text.remove_prefix(kept);
        const std::size_t end = std::min(text.find_first_of("\r\n\t"), text.size());
        clean += cleanText(text.substr(0, end));
        text.remove_prefix(end);
        // A carriage return alone would write over its line.
        if (text.starts_with('\r') && !text.starts_with("\r\n")) takeCharacter(text, clean);
    }
    return clean;
}

std::string trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == text.npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

std::string countOf(std::uint64_t count, std::string_view noun, std::string_view plural) {
    if (count == 1) return fmt::format("1 {}", noun);
    return plural.empty() ? fmt::format("{} {}s", fmt::group_digits(count), noun)
                          : fmt::format("{} {}", fmt::group_digits(count), plural);
}

std::string quoteForShell(const std::string& text) {
    const auto harmless = [](unsigned char c) {
        return std::isalnum(c) != 0 || c > 127 ||
               std::string_view("-_./,:+@%=").find(char(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, harmless)) return text;
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string escapeXml(std::string_view text) {
    std::string safe;
    for (const char letter : text) {
        if (letter == '<')
            safe += "&lt;";
        else if (letter == '>')
            safe += "&gt;";
        else if (letter == '&')
            safe += "&amp;";
        else if (letter == '"')
            safe += "&quot;";
        else
            safe += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    }
    return safe;
}

}  // namespace noonmark
