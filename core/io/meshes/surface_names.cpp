#include "core/io/meshes/surface_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace noonmark {

namespace {

struct Word {
    std::string_view text;
    enum class Kind { other, number, surface, cityGml } kind = Kind::other;
};

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

bool endsWordBefore(std::string_view name, std::size_t i) {
    return isCapital(name[i]) && !isCapital(name[i - 1]);
}

Word::Kind getKind(std::string_view text) {
    constexpr std::array cityGml{"wallsurface",
                                 "roofsurface",
                                 "groundsurface",
                                 "closuresurface",
                                 "floorsurface",
                                 "ceilingsurface",
                                 "outerceilingsurface",
                                 "outerfloorsurface",
                                 "surface",
                                 "surfaces",
                                 "surf"};
    constexpr std::array plain{"wall",    "walls",   "roof",     "roofs",   "ground",  "floor",
                               "ceiling", "closure", "outer",    "door",    "doors",   "window",
                               "windows", "opening", "openings", "facade",  "facades", "dach",
                               "wand",    "waende",  "boden",    "fenster", "toit",    "mur",
                               "murs",    "sol",     "dak",      "muur",    "gevel"};
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (std::ranges::find(cityGml, lower) != cityGml.end()) return Word::Kind::cityGml;
    if (std::ranges::find(plain, lower) != plain.end()) return Word::Kind::surface;
    return std::ranges::all_of(lower, isDigit) ? Word::Kind::number : Word::Kind::other;
}

std::vector<Word> describe(std::string_view name) {
    std::vector<Word> words;
    const auto isPart = [](char c) { return isLetter(c) || isDigit(c); };
    for (std::size_t i = 0; i < name.size();) {
        std::size_t end = i;
        while (end < name.size() && isPart(name[end]) && (end == i || !endsWordBefore(name, end))) ++end;
        if (end > i) words.push_back({name.substr(i, end - i), getKind(name.substr(i, end - i))});
        i = std::max(end, i + 1);
    }
    return words;
}

bool isSurface(const Word& word) {
    return word.kind == Word::Kind::surface || word.kind == Word::Kind::cityGml;
}

bool isOther(const Word& word) { return word.kind == Word::Kind::other; }

}  // namespace

std::string stemOfSurfaceName(std::string_view name) {
    const std::vector<Word> words = describe(name);
    const auto lastSurface = std::find_if(words.rbegin(), words.rend(), isSurface).base();
    if (lastSurface == words.begin()) return {};
    // Numbers after the last such word number a building's surfaces, unless a name follows.
    const bool isLast = std::none_of(lastSurface, words.end(), isOther);
    std::string stem;
    for (auto word = words.begin(); word != words.end(); ++word) {
        const bool counts = isLast && word >= lastSurface && word->kind == Word::Kind::number;
        if (isSurface(*word) || counts) continue;
        if (!stem.empty()) stem.push_back('_');
        stem.append(word->text);
    }
    const bool named = std::ranges::any_of(words, isOther);
    const bool cityGml =
        std::ranges::any_of(words, [](const Word& w) { return w.kind == Word::Kind::cityGml; });
    return named || cityGml ? stem : std::string();
}

bool isOnlySurfaceName(std::string_view name) {
    const std::vector<Word> words = describe(name);
    return std::ranges::any_of(words, isSurface) && std::ranges::none_of(words, isOther);
}

}  // namespace noonmark
