#pragma once

#include <glm/vec2.hpp>
#include <utility>

namespace noonmark {

/// Where an edge meets a horizontal line: the one rule that `contains` and the rasteriser share, so that they
/// agree to the last bit. The same answer whichever way the edge runs, so that neighbours on a shared edge
/// agree too.

/// Half-open: the edge's lower end is on it, the upper end is not; a horizontal edge never crosses.
inline bool crossesRow(glm::vec2 a, glm::vec2 b, double y) {
    return (double(a.y) <= y) != (double(b.y) <= y);
}

/// x of the crossing, metres; only where crossesRow().
inline double crossingX(glm::vec2 a, glm::vec2 b, double y) {
    if (a.y > b.y) std::swap(a, b);
    return double(a.x) + (y - double(a.y)) * (double(b.x) - double(a.x)) / (double(b.y) - double(a.y));
}

}  // namespace noonmark
