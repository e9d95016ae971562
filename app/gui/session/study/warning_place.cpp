#include "app/gui/session/study/warning_place.h"

#include <cctype>

namespace noonmark {

namespace {

bool isOfWord(const std::string& text, std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
}

bool holdsWord(const std::string& text, const std::string& word) {
    if (word.empty()) return false;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const bool begins = at == 0 || !isOfWord(text, at - 1);
        if (begins && !isOfWord(text, at + word.size())) return true;
    }
    return false;
}

}  // namespace

std::optional<std::uint32_t> buildingNamed(const City& city, const std::string& where) {
    std::optional<std::uint32_t> found;
    std::size_t longest = 0;
    const auto look = [&](std::uint32_t building, const std::string& id) {
        if (id.size() <= longest || !holdsWord(where, id)) return;
        found = building;
        longest = id.size();
    };
    for (std::uint32_t i = 0; i < city.buildings.size(); ++i) {
        look(i, city.buildings[i]->sourceId);
        for (const Part& part : city.buildings[i]->parts) look(i, part.sourceId);
    }
    return found;
}

}  // namespace noonmark
