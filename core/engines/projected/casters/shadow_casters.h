#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/engines/projected/casters/ring_lines.h"
#include "core/geo/grid.h"

namespace noonmark {

/// One convex piece of what throws a shadow on flat ground. Coordinates in cells of a grid (the centre of
/// cell (0, 0) is at (0, 0)), heights in metres above the receivers, which stand where placeRayOrigin() puts
/// them.
struct ShadowCaster {
    enum class Kind : std::uint8_t {
        prism,  ///< a convex polygon (counter-clockwise) from bottom to top
        wall,   ///< two points: a wall from bottom to top; throws only when it faces away from the sun (left
                ///< of first -> second is inside)
        flat,   ///< a convex polygon at one height, `bottom`: a triangle of the underside of something that
                ///< hangs
        face,   ///< three points of a mesh, each with its height in `heights`; throws when it faces the sun
    };
    static constexpr std::size_t mostPoints = 60;
    Kind kind = Kind::prism;
    std::uint32_t firstPoint = 0;  ///< into ShadowCasters::points
    std::uint32_t pointCount = 0;
    std::uint32_t firstEdge = 0;  ///< into ShadowCasters::edges, one from each point; a face has none
    float bottomM = 0;
    float topM = 0;
    std::array<float, 3> heights{};  ///< of a face only
    bool twoSided = false;           ///< a face of a mesh that is not closed: throws from behind, too
    bool stands = false;             ///< a prism on the ground: no receiver is under it
    std::uint32_t building = 0;      ///< index in City::buildings
    glm::dvec2 low{}, high{};        ///< bounds of the points, cells
};

/// Everything of some buildings that throws shadow, as convex pieces.
struct ShadowCasters {
    std::vector<ShadowCaster> casters;
    std::vector<glm::dvec2> points;
    std::vector<RingEdge> edges;

    [[nodiscard]] std::span<const glm::dvec2> pointsOf(const ShadowCaster& caster) const {
        return std::span(points).subspan(caster.firstPoint, caster.pointCount);
    }
    [[nodiscard]] std::span<const RingEdge> edgesOf(const ShadowCaster& caster) const {
        return std::span(edges).subspan(caster.firstEdge, caster.pointCount);
    }
};

/// A convex prism stays whole. Any other becomes its walls (those that face away from the sun throw all of
/// its shadow that lies outside its footprint), and, where it hangs, its underside; a mesh becomes its faces,
/// seen from both sides where it is not closed. `buildings`: indices into the city, each on flat ground z =
/// 0.
ShadowCasters makeShadowCasters(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid);

}  // namespace noonmark
