#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/city/city.h"

namespace noonmark {

/// A flat convex face, counter-clockwise from outside.
struct CasterFace {
    std::array<std::uint32_t, 4> corner{};  ///< into CasterFaces::points
    std::uint8_t corners = 3;               ///< 3 or 4
    bool twoSided = false;                  ///< of a mesh that is not closed: throws from behind, too
};

/// All faces of some buildings and of the terrain, as depth maps take them: walls whole, caps and meshes in
/// triangles. Terrain is the top of the solid below it. Local metres.
struct CasterFaces {
    std::vector<glm::vec3> points;
    std::vector<CasterFace> faces;
};

/// `buildings`: indices into the city. O(points log points), all cores; after a stop request it returns soon,
/// with what it has: look at the token.
CasterFaces makeCasterFaces(const City& city, std::span<const std::uint32_t> buildings,
                            const std::stop_token& stop = {});

}  // namespace noonmark
