#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace noonmark {

/// Receiver points on any surface: ground, roofs, facades, terrain. Two arrays of the same size; neighbours
/// in the arrays should be neighbours in space, or engines are slower.
struct SurfacePoints {
    std::vector<glm::vec3> positions;  ///< local metres, on the surface
    std::vector<glm::vec3> normals;    ///< unit vectors, outward from the surface
    /// Position of the viewer. Engines that rasterise give more of their resolution to the surroundings of
    /// this position; without it, all points get the same.
    std::optional<glm::vec3> eye;

    [[nodiscard]] std::size_t size() const { return positions.size(); }
};

}  // namespace noonmark
