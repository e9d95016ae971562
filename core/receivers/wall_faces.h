#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "core/city/building.h"

namespace noonmark {

/// An upright plane face of a part, outside at its right. In the face's own plane a place is (along, z):
/// metres from `start`, and local z.
struct WallFace {
    glm::dvec2 start{};
    glm::dvec2 along{};  ///< unit vector
    double lengthM = 0;
    double lowM = 0, highM = 0;
    /// The triangles that make up the face; empty: all of its rectangle.
    std::vector<std::array<glm::dvec2, 3>> triangles;

    [[nodiscard]] glm::dvec2 normal() const { return {along.y, -along.x}; }
    [[nodiscard]] bool covers(glm::dvec2 place) const;
};

/// The walls of a prism, or the faces of a mesh within 6 degrees of vertical, joined where they lie in one
/// plane (to about 1 degree and 5 cm). O(n log n).
std::vector<WallFace> findWallFaces(const Part& part);

}  // namespace noonmark
