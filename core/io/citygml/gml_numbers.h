#pragma once

#include <glm/mat4x4.hpp>
#include <string_view>
#include <vector>

namespace noonmark {

/// Fills `numbers` with those of a list that is separated by blanks or, as in GML 2, by commas. False if
/// there is something else, or a number that is not finite.
bool readGmlNumbers(std::string_view text, std::vector<double>& numbers);

/// A matrix written row by row; the identity if it has not 16 numbers.
glm::dmat4 readGmlMatrix(std::string_view text);

}  // namespace noonmark
