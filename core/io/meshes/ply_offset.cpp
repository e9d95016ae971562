#include "core/io/meshes/stated_axes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

namespace {

constexpr std::size_t maxPlyHeaderBytes = 65536;
constexpr double minOffset = 1000;  // less is no place on a map

std::string inSmallLettersOf(std::string_view line) {
    std::string small(line);
    for (char& letter : small) letter = char(std::tolower(static_cast<unsigned char>(letter)));
    return small;
}

// What follows a word that names an offset; empty: there is none.
std::string_view behindOffsetWord(std::string_view comment) {
    constexpr std::array<std::string_view, 3> words{"offset", "translation", "origin"};
    for (const std::string_view word : words)
        if (const auto at = comment.find(word); at != comment.npos) return comment.substr(at + word.size());
    return {};
}

std::vector<double> listNumbers(std::string_view text) {
    std::vector<double> numbers;
    while (!text.empty()) {
        const auto begin = text.find_first_of("+-.0123456789");
        if (begin == text.npos) break;
        text.remove_prefix(begin + (text[begin] == '+' ? 1 : 0));
        double number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error == std::errc()) numbers.push_back(number);
        text.remove_prefix(std::max<std::size_t>(1, std::size_t(end - text.data())));
    }
    return numbers;
}

std::optional<glm::dvec3> parseOffset(std::string_view line) {
    if (!line.starts_with("comment") && !line.starts_with("obj_info")) return std::nullopt;
    const std::vector<double> numbers = listNumbers(behindOffsetWord(line));
    if (numbers.size() != 3 || !std::ranges::all_of(numbers, [](double one) { return std::isfinite(one); }))
        return std::nullopt;
    if (std::max(std::abs(numbers[0]), std::abs(numbers[1])) < minOffset) return std::nullopt;
    return glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

}  // namespace

std::optional<glm::dvec3> readPlyOffset(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string header(maxPlyHeaderBytes, '\0');
    stream.read(header.data(), std::streamsize(header.size()));
    header.resize(std::size_t(stream.gcount()));
    std::istringstream lines(header.substr(0, header.find("end_header")));
    for (std::string line; std::getline(lines, line);)
        if (const auto offset = parseOffset(inSmallLettersOf(line))) return offset;
    return std::nullopt;
}

}  // namespace noonmark
