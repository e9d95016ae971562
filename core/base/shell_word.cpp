#include "core/base/shell_word.h"

#include <algorithm>
#include <cctype>
#include <string_view>

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

}  // namespace noonmark
