#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/common/sun_interval.h"
#include "core/geo/grid.h"
#include "core/receivers/point_receivers.h"

namespace noonmark {

/// Ways to lay a square map of `mapSize` texels per side over points of a plane. They return the matrix
/// MapFrame::texelFromPlane. Every point lies on the map.

/// Stretches the map over the points' bounding box.
glm::dmat3 fitBox(std::span<const glm::dvec2> points, int mapSize);

/// Stretches the map over a trapezoid around the points whose narrow side faces `eye` (Martin and Tan,
/// Anti-aliasing and continuity with trapezoidal shadow maps, 2004): the axis runs from the eye to the centre
/// of the points, and the closest 80 % of them get 80 % of the map's length (their 80 % rule, with the focus
/// where that many points are). Empty if the warp would not help: points no denser near the eye, or the eye
/// above their centre.
std::optional<glm::dmat3> fitTrapezoid(std::span<const glm::dvec2> points, glm::dvec2 eye, int mapSize);

/// The plane and the texels of the depth maps of an interval. Every step of the sun projects the city onto
/// the same plane, so steps differ only by a shear (the paper's tan law in two dimensions): a point `w`
/// metres above the plane appears at its foot minus w x shearOf(sun).
///
/// Depth is w, metres towards the sun along the plane's normal: larger is closer to the sun, and it is the
/// same at every step.
struct MapFrame {
    /// Parts with a smaller q, close to the warp's centre, are not drawn: they lie far outside the map.
    static constexpr double minQ = 1e-3;

    glm::dvec3 origin{0};  ///< on the plane, local metres
    glm::dvec3 u{1, 0, 0};
    glm::dvec3 v{0, 1, 0};
    glm::dvec3 normal{0, 0, 1};  ///< u, v, normal: unit vectors, right-handed; sun . normal > 0
    /// Maps plane metres (x, y, 1) to texels, up to the third coordinate q; without a warp q is 1 everywhere.
    /// Texel (column, row) has its centre at (column, row).
    glm::dmat3 texelFromPlane{1};
    int columns = 0;
    int rows = 0;

    /// Plane coordinates of a point's foot, and its height w above the plane.
    [[nodiscard]] glm::dvec3 placed(glm::vec3 point) const;
    [[nodiscard]] std::vector<glm::dvec3> placed(const std::vector<glm::vec3>& points) const;  ///< all cores

    /// The same for a direction; only the rotation applies.
    [[nodiscard]] glm::dvec3 turned(glm::dvec3 direction) const;

    /// Displacement on the plane, against the shadow's direction, per metre of w.
    [[nodiscard]] glm::dvec2 shearOf(glm::dvec3 towardsSun) const;

    /// Position at which a placed point appears under a shear: (column q, row q, q).
    [[nodiscard]] glm::dvec3 homogeneous(glm::dvec3 placed, glm::dvec2 shear) const {
        return texelFromPlane * glm::dvec3(placed.x - placed.z * shear.x, placed.y - placed.z * shear.y, 1.0);
    }

    /// The same as (column, row); q must be above 0.
    [[nodiscard]] glm::dvec2 texel(glm::dvec3 placed, glm::dvec2 shear) const {
        const glm::dvec3 h = homogeneous(placed, shear);
        return {h.x / h.z, h.y / h.z};
    }
};

/// For cells of a flat grid: the plane is the ground, so cells stay in place at every step, and the map
/// covers the grid's box. The trapezoid around a box is the box itself, so there is no warp. `texelsOnCells`
/// as in AccrualSettings.
MapFrame makeGroundFrame(const Grid& grid, int mapSize, bool texelsOnCells);

/// For points on any surface, in one interval: a plane through their centre at a right angle to the sun's
/// mean direction, so that points on both sides of it move little from step to step. The map contains all
/// points at every step. With `warp` and an eye, the map is a trapezoid around them that widens away from the
/// eye. Needs at least one point. O(points), all cores.
MapFrame makeSurfaceFrame(const SurfacePoints& points, const SunInterval& interval, int mapSize, bool warp);

}  // namespace noonmark
