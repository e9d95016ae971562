#pragma once

// Words and numbers of the lines of a text that is in memory; texts of meshes have millions of them.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace noonmark {

inline std::string readWholeFile(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    std::string content(error ? 0 : std::size_t(size), '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(content.data(), std::streamsize(content.size()));
    content.resize(std::size_t(stream.gcount()));
    return content;
}

inline bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// Takes the next line, without its end.
inline std::string_view takeLine(std::string_view& text) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Takes the next word and the blanks before it; empty at the end of the line.
inline std::string_view takeWord(std::string_view& line) {
    const auto first = std::find_if_not(line.begin(), line.end(), isBlank);
    const auto end = std::find_if(first, line.end(), isBlank);
    const std::string_view word(first, end);
    line = std::string_view(end, line.end());
    return word;
}

/// Takes the next word where it is a finite number.
inline std::optional<double> takeNumber(std::string_view& line) {
    std::string_view word = takeWord(line);
    if (word.starts_with('+')) word.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number))
        return std::nullopt;
    return number;
}

}  // namespace noonmark
