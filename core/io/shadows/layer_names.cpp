#include "core/io/shadows/layer_names.h"

#include <algorithm>

namespace noonmark {

namespace {

constexpr std::size_t maxLetters = 200;

bool isPlain(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '-' || letter == '_' || letter == '.';
}

// The first byte of a letter in UTF-8 stands for the letter.
std::string plainName(std::string_view wanted) {
    std::string name;
    for (const char letter : wanted)
        if ((static_cast<unsigned char>(letter) & 0xC0U) != 0x80U) name += isPlain(letter) ? letter : '_';
    name.resize(std::min(name.size(), maxLetters));
    return name.empty() ? "layer" : name;
}

std::string lowerCase(std::string name) {
    std::ranges::transform(name, name.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter;
    });
    return name;
}

}  // namespace

std::string LayerNames::add(std::string_view wanted) {
    const std::string plain = plainName(wanted);
    std::string name = plain;
    for (int copy = 2; !taken_.insert(lowerCase(name)).second; ++copy)
        name = plain + "_" + std::to_string(copy);
    return name;
}

}  // namespace noonmark
