#include "core/io/footprints/other_tags.h"

#include <optional>

namespace noonmark {

namespace {

// Takes a quoted word from the front of `text`; nothing if there is none.
std::optional<std::string> takeQuoted(std::string_view& text) {
    if (!text.starts_with('"')) return std::nullopt;
    std::string word;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '"') {
            text.remove_prefix(i + 1);
            return word;
        }
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        word += text[i];
    }
    return std::nullopt;
}

bool take(std::string_view& text, std::string_view mark) {
    if (!text.starts_with(mark)) return false;
    text.remove_prefix(mark.size());
    return true;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> parseTags(std::string_view text) {
    std::vector<std::pair<std::string, std::string>> tags;
    do {
        auto key = takeQuoted(text);
        if (!key || !take(text, "=>")) break;
        auto value = takeQuoted(text);
        if (!value) break;
        tags.emplace_back(*std::move(key), *std::move(value));
    } while (take(text, ","));
    return tags;
}

}  // namespace noonmark
