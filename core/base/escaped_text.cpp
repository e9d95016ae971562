#include "core/base/escaped_text.h"

#include <algorithm>
#include <cctype>

namespace noonmark {

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
