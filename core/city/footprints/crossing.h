#pragma once

#include <glm/vec2.hpp>
#include <utility>

namespace noonmark {

/// The intersection of an edge with a horizontal line. `contains` and the rasteriser share this rule, so that
/// they agree to the last bit. The result does not depend on the direction of the edge, so that neighbours
/// agree on a shared edge too.

/// Half-open: a line through the edge's lower end crosses it, a line through the upper end does not; a
/// horizontal edge never crosses.
inline bool crossesRow(glm::vec2 a, glm::vec2 b, double y) {
    return (double(a.y) <= y) != (double(b.y) <= y);
}

/// x of the crossing, metres; valid only if crossesRow().
inline double crossingX(glm::vec2 a, glm::vec2 b, double y) {
    if (a.y > b.y) std::swap(a, b);
    return double(a.x) + (y - double(a.y)) * (double(b.x) - double(a.x)) / (double(b.y) - double(a.y));
}

}  // namespace noonmark
