#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace noonmark {

/// Places on any surface that receive shadow: ground, roofs, facades, terrain. Two arrays of the same size;
/// neighbours in the arrays should be neighbours in space, or engines are slower.
struct SurfacePoints {
    std::vector<glm::vec3> positions;  ///< local metres, on the surface
    std::vector<glm::vec3> normals;    ///< unit, outward: the side that is looked at
    /// Where they are seen from. Engines that work on a raster give what is near it more of their resolution;
    /// none: all alike.
    std::optional<glm::vec3> eye;

    [[nodiscard]] std::size_t size() const { return positions.size(); }
};

}  // namespace noonmark
