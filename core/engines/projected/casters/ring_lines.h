#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "core/geo/grid.h"

namespace noonmark {

/// Position of a point in cells of a grid: the centre of cell (0, 0) is at (0, 0).
inline glm::dvec2 toCells(const Grid& grid, glm::dvec2 local) {
    return {(local.x - grid.westM) / grid.cellM - 0.5, (local.y - grid.southM) / grid.cellM - 0.5};
}

/// Offset, in cells, of the shadow of a point one metre up from the point below it. `towardsSun`: above the
/// horizon.
inline glm::dvec2 shadowOffsetInCells(glm::dvec3 towardsSun, double cellM) {
    return glm::dvec2(towardsSun.x, towardsSun.y) / (-towardsSun.z * cellM);
}

/// Whether an edge is so level that it bounds no row: cells this close to it are within rounding.
inline bool isLevel(glm::dvec2 a, glm::dvec2 b) { return std::abs(b.y - a.y) < 1e-6; }

/// An edge of a counter-clockwise ring, in cells; the interior is on its left.
struct RingEdge {
    enum class Side : std::uint8_t { western, eastern, level };
    glm::dvec2 along{};  ///< vector from its first point to its second
    double atRow0 = 0;   ///< the line that contains it: column = atRow0 + row x slope
    double slope = 0;
    double low = 0, high = 0;  ///< range of its rows
    Side side = Side::level;

    RingEdge() = default;
    /// Gives the same line whichever way the edge runs, so neighbours that share it leave no gap and share no
    /// cell.
    RingEdge(glm::dvec2 a, glm::dvec2 b) : along(b - a), low(std::min(a.y, b.y)), high(std::max(a.y, b.y)) {
        if (isLevel(a, b)) return;
        side = b.y > a.y ? Side::eastern : Side::western;
        if (b.y < a.y) std::swap(a, b);
        slope = (b.x - a.x) / (b.y - a.y);
        atRow0 = a.x - a.y * slope;
    }
};

}  // namespace noonmark
