#include "core/study/verification/compare_words.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

namespace noonmark {

namespace {

using Words = std::vector<std::string>;

constexpr std::size_t matchWords = 3;
constexpr std::size_t searchedWords = 400;
constexpr std::size_t wordsBefore = 4;

bool hasDigit(const std::string& word) {
    return std::ranges::any_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

// Durations of the computation become a star: "0.1 s in total".
void maskDurations(Words& words) {
    for (std::size_t i = 0; i + 3 < words.size(); ++i)
        if (hasDigit(words[i]) && words[i + 2] == "in" && words[i + 3].starts_with("total")) words[i] = "*";
}

Words wordsOf(const std::string& text) {
    std::istringstream stream(text);
    Words words;
    for (std::string word; stream >> word;) words.push_back(std::move(word));
    maskDurations(words);
    return words;
}

bool matches(const Words& a, std::size_t i, const Words& b, std::size_t j) {
    if (i == a.size() && j == b.size()) return true;
    const std::size_t most = std::min({matchWords, a.size() - i, b.size() - j});
    return most > 0 && std::equal(a.begin() + std::ptrdiff_t(i), a.begin() + std::ptrdiff_t(i + most),
                                  b.begin() + std::ptrdiff_t(j));
}

// The nearest place at which both texts go on alike; their ends if there is none.
std::pair<std::size_t, std::size_t> findMatch(const Words& a, std::size_t i, const Words& b, std::size_t j) {
    for (std::size_t distance = 1; distance <= searchedWords; ++distance)
        for (std::size_t skipped = 0; skipped <= distance; ++skipped)
            if (i + skipped <= a.size() && j + distance - skipped <= b.size() &&
                matches(a, i + skipped, b, j + distance - skipped))
                return {i + skipped, j + distance - skipped};
    return {a.size(), b.size()};
}

std::string join(const Words& words, std::size_t from, std::size_t to) {
    std::string text;
    for (std::size_t i = from; i < to; ++i) text += (i > from ? " " : "") + words[i];
    return text;
}

}  // namespace

WordComparison compareWords(const std::string& recorded, const std::string& computed) {
    const Words a = wordsOf(recorded), b = wordsOf(computed);
    WordComparison result{std::size_t(std::ranges::count_if(a, hasDigit)), {}};
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        if (i < a.size() && j < b.size() && a[i] == b[j]) {
            ++i, ++j;
            continue;
        }
        const auto [nextI, nextJ] = findMatch(a, i, b, j);
        WordDifference difference{join(a, i - std::min(i, wordsBefore), i), join(a, i, nextI),
                                  join(b, j, nextJ), false};
        difference.hasFigure = hasDigit(difference.recorded) || hasDigit(difference.computed);
        result.differences.push_back(std::move(difference));
        i = nextI;
        j = nextJ;
    }
    return result;
}

}  // namespace noonmark
