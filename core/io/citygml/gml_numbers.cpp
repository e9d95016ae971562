#include "core/io/citygml/gml_numbers.h"

#include <charconv>
#include <cmath>
#include <glm/matrix.hpp>

namespace noonmark {

namespace {

bool isBetween(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ','; }

}  // namespace

bool readGmlNumbers(std::string_view text, std::vector<double>& numbers) {
    numbers.clear();
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        while (at != end && isBetween(*at)) ++at;
        if (at == end) return true;
        if (*at == '+') ++at;
        double number = 0;
        const auto [after, error] = std::from_chars(at, end, number);
        if (error != std::errc() || !std::isfinite(number)) return false;
        numbers.push_back(number);
        at = after;
        if (at != end && !isBetween(*at)) return false;
    }
}

glm::dmat4 readGmlMatrix(std::string_view text) {
    std::vector<double> numbers;
    glm::dmat4 matrix(1);
    if (!readGmlNumbers(text, numbers) || numbers.size() != 16) return matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = numbers[std::size_t(4 * row + column)];
    return matrix;
}

}  // namespace noonmark
