#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "core/engines/common/interval_engine.h"
#include "core/geo/grid.h"
#include "core/receivers/surface_points.h"

namespace noonmark {

/// Where the depth maps of an interval lie: a plane, and texels on it. Every step of the sun throws the city
/// onto this one plane, so what differs between steps is a shear alone (the paper's tan law, in two
/// dimensions): a point `w` metres before the plane appears at its foot minus w x shearOf(sun).
///
/// Depth is w, metres towards the sun along the plane's normal: larger is nearer to the sun, and it is the
/// same at every step.
struct MapFrame {
    /// Nearer to the warp's centre than this q nothing is drawn: it lies far off the map.
    static constexpr double leastQ = 1e-3;

    glm::dvec3 origin{0};  ///< on the plane, local metres
    glm::dvec3 u{1, 0, 0};
    glm::dvec3 v{0, 1, 0};
    glm::dvec3 normal{0, 0, 1};  ///< u, v, normal: unit vectors, right-handed; sun . normal > 0
    /// Texels from plane metres (x, y, 1), up to the third coordinate q; q is 1 everywhere where there is no
    /// warp. Texel (column, row) has its centre at (column, row).
    glm::dmat3 texelFromPlane{1};
    int columns = 0;
    int rows = 0;

    /// Plane coordinates of a point's foot, and its height w before the plane.
    [[nodiscard]] glm::dvec3 placed(glm::vec3 point) const;
    [[nodiscard]] std::vector<glm::dvec3> placed(const std::vector<glm::vec3>& points) const;  ///< all cores

    /// The same for a direction, which has no place.
    [[nodiscard]] glm::dvec3 turned(glm::dvec3 direction) const;

    /// Metres on the plane that the shadow of a point moves against, a metre of w.
    [[nodiscard]] glm::dvec2 shearOf(glm::dvec3 towardsSun) const;

    /// Where something placed appears under a shear: (column q, row q, q).
    [[nodiscard]] glm::dvec3 homogeneous(glm::dvec3 placed, glm::dvec2 shear) const {
        return texelFromPlane * glm::dvec3(placed.x - placed.z * shear.x, placed.y - placed.z * shear.y, 1.0);
    }

    /// The same as (column, row); q must be above 0.
    [[nodiscard]] glm::dvec2 texel(glm::dvec3 placed, glm::dvec2 shear) const {
        const glm::dvec3 h = homogeneous(placed, shear);
        return {h.x / h.z, h.y / h.z};
    }
};

/// For cells of a flat grid: the plane is the ground, so cells stay where they are at every step, and the map
/// is the grid's box: the trapezoid around it is the box itself, and there is nothing to warp.
/// `texelsOnCells` as in AccrualSettings.
MapFrame makeGroundFrame(const Grid& grid, int mapSize, bool texelsOnCells);

/// For points on any surface, in one interval: a plane through their middle at right angles to the sun's mean
/// direction, so that points before and behind it move little from step to step; the map holds them all at
/// every step. With `warp` and an eye, the map is a trapezoid around them that opens away from the eye
/// (trapezoid.h). At least one point. O(points), all cores.
MapFrame makeSurfaceFrame(const SurfacePoints& points, const SunInterval& interval, int mapSize, bool warp);

}  // namespace noonmark
