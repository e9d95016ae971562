#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/city/footprints/footprint.h"
#include "core/engines/projected/casters/ring_lines.h"
#include "core/engines/projected/filling/step_lanes.h"
#include "core/geo/grid.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Whether a repaired footprint has no hole and no corner that turns right; points on a straight wall are
/// ignored. A ring may turn left all the way and still wind twice, but repaired footprints never do.
/// O(points).
bool isConvex(const Footprint& footprint);

/// Splits a footprint into convex pieces that contain each of its edges once: sections of a ring that turn
/// left all the way, closed by a chord inside the footprint. Prisms over all pieces cast the same shadow as
/// the footprint's walls. Points in ring order, at most `maxPoints` per piece; a piece of two points is a
/// single edge. The footprint must be properly repaired. O(points x (points that turn right + points of
/// holes)).
std::vector<Ring> splitIntoConvexPieces(const Footprint& footprint, std::size_t maxPoints);

// Casters: occluders as convex pieces whose shadows are polygons. In this file, ShadowCasters holds those of
// some buildings, BuildingCasters groups them by building, and sun directions become offsets in cells.
// shadow_casters.h splits footprints; ring_lines.h converts points to cells and describes edges as lines.
// caster_shaping-inl.h computes a caster's shadow at eight steps.

/// A convex caster on flat ground. Coordinates in cells of a grid (the centre of cell (0, 0) is at (0, 0)),
/// heights in metres above the receivers, which are at the positions of placeRayOrigin().
struct ShadowCaster {
    enum class Kind : std::uint8_t {
        prism,  ///< a convex polygon (counter-clockwise) from bottom to top
        wall,   ///< two points: a wall from bottom to top; casts shadow only if it faces away from the sun
                ///< (the interior is left of first -> second)
        flat,   ///< a convex polygon at one height, `bottom`: a triangle of the underside of an overhang
        face,   ///< three points of a mesh with their heights in `heights`; casts shadow if it faces the sun
    };
    static constexpr std::size_t maxPoints = 60;
    Kind kind = Kind::prism;
    std::uint32_t firstPoint = 0;  ///< index in ShadowCasters::points
    std::uint32_t pointCount = 0;
    std::uint32_t firstEdge = 0;  ///< index in ShadowCasters::edges, one edge per point; none for a face
    float bottomM = 0;
    float topM = 0;
    std::array<float, 3> heights{};  ///< only for a face
    bool twoSided = false;  ///< a face of a mesh that is not closed: also casts shadow if seen from behind
    bool stands = false;    ///< a prism on the ground: no receiver is under it
    std::uint32_t building = 0;  ///< index in City::buildings
    glm::dvec2 low{}, high{};    ///< bounds of the points, cells
};

/// All casters of some buildings.
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

/// A convex prism is one caster. Any other prism is split: on the ground into convex pieces, as an overhang
/// into its walls (those that face away from the sun cast all of its shadow outside its footprint) and its
/// underside. A mesh is split
/// into its faces, two-sided if it is not closed. `buildings`: indices in the city, each on flat ground at z
/// = 0.
ShadowCasters makeShadowCasters(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid);

/// Offsets for the steps from `first` to `end`: the first eight individually, with the period's last step
/// repeated if there are fewer, and the bounds of all. The period must not be empty.
StepOffsets computeOffsets(const SunSteps& sun, double cellM, std::size_t first, std::size_t end);

/// Offsets of the period in groups of eight steps.
std::vector<StepOffsets> computeOffsetsByEight(const SunSteps& sun, double cellM);

/// The casters of some buildings on flat ground, grouped by building.
class BuildingCasters {
public:
    BuildingCasters(std::vector<std::shared_ptr<const Building>> buildings, const Grid& grid);

    [[nodiscard]] const ShadowCasters& casters() const { return casters_; }
    [[nodiscard]] std::size_t buildings() const { return ends_.size(); }
    /// Indices of one building's casters.
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t building) const {
        const std::size_t first = building == 0 ? 0 : ends_[building - 1];
        return std::span(order_).subspan(first, ends_[building] - first);
    }

private:
    ShadowCasters casters_;
    std::vector<std::uint32_t> order_;  // indices of casters, by building
    std::vector<std::size_t> ends_;     // end of each building in order_
};

}  // namespace noonmark
