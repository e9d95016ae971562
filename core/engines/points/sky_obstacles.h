#pragma once

// The folder core/engines/points measures sunlight and sky at single points on any surface. sky_obstacles.h
// lists what can hide the sky; skyline.h is the exact skyline of one point, made by skyline_envelope.h;
// sky_factors.h integrates the visible sky over it, and point_sunlight.h tells when it lets the sun through.
// For many points, point_horizons.h counts minutes from horizons by bins of azimuth (folder horizons).

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/city/city.h"

namespace noonmark {

/// An edge with solid below it, down to the ground: of a roof, of a mesh that stands on the ground, of the
/// terrain.
struct TopEdge {
    glm::vec3 a, b;
    std::uint32_t building = 0;  ///< index in City::buildings, or SkyObstacles::terrain
    /// The top of a prism's wall, with the interior to the left of a -> b: hides nothing from behind.
    bool oneSided = false;
};

/// A triangle of an overhang: the sky is seen below it.
struct OverhangFace {
    std::array<glm::vec3, 3> corners;
    std::uint32_t building = 0;
};

/// Everything that can hide the sky, in local metres. The same solids as the horizon sweep: a part that is
/// not an overhang is solid down to the ground.
struct SkyObstacles {
    static constexpr std::uint32_t terrain = 0xFFFFFFFF;
    static constexpr std::uint32_t ownWall =
        0xFFFFFFFE;  ///< the surface of the point faces away from the sun
    std::vector<TopEdge> edges;
    std::vector<OverhangFace> faces;
};

/// O(points of the parts + posts of the terrain); 5 ms for Midtown's 8,000 buildings.
SkyObstacles collectSkyObstacles(const City& city);

}  // namespace noonmark
