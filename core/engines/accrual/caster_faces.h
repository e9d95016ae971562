#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/city/city.h"

namespace noonmark {

/// A flat convex face, counter-clockwise as seen from outside.
struct CasterFace {
    std::array<std::uint32_t, 4> corner{};  ///< indices in CasterFaces::points
    std::uint8_t corners = 3;               ///< number of corners, 3 or 4
    bool twoSided = false;  ///< part of a mesh that is not closed: also casts shadow if seen from behind
};

/// All faces of some buildings and of the terrain in the form that depth maps use: walls as quadrilaterals,
/// caps and meshes as triangles. Terrain is the top of the solid below it. Local metres.
struct CasterFaces {
    std::vector<glm::vec3> points;
    std::vector<CasterFace> faces;
};

/// `buildings`: indices in the city. O(points log points), all cores. Returns soon after a stop request with
/// an incomplete result; the caller must check the token.
CasterFaces makeCasterFaces(const City& city, std::span<const std::uint32_t> buildings,
                            const std::stop_token& stop = {});

}  // namespace noonmark
