#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace noonmark {

/// Coordinates in which the shadows of one azimuth run over the cells of a grid. `along` is the grid axis
/// closer to the shadows' direction, oriented so that shadows run towards higher `along`; `across` is the
/// other axis. q = across - k along is constant along a shadow. Unit: cells, with cell centres at whole
/// numbers.
struct ShadowAxes {
    /// `away`: unit vector in which shadows fall.
    explicit ShadowAxes(glm::dvec2 away)
        : swapped(std::abs(away.x) > std::abs(away.y)),
          sign((swapped ? away.x : away.y) < 0 ? -1 : 1),
          alongPerDistance(std::abs(swapped ? away.x : away.y)),
          k((swapped ? away.y : away.x) / alongPerDistance) {}

    struct Point {
        double q;
        double along;
    };
    [[nodiscard]] Point from(glm::dvec2 cells) const {
        const double along = sign * (swapped ? cells.x : cells.y);
        return {(swapped ? cells.y : cells.x) - k * along, along};
    }

    /// Whether the mapping from (across, along) to (x, y) reverses orientation.
    [[nodiscard]] bool mirrored() const { return swapped != (sign < 0); }

    bool swapped;             ///< `along` is the x axis
    double sign;              ///< orientation of the axis: 1 or -1
    double alongPerDistance;  ///< `along` covered per unit of distance along the azimuth: 0.7 to 1
    double k;                 ///< -1 to 1
};

/// Bounding box of points in the axes of one azimuth.
struct ShadowExtent {
    double lowQ = 1e300, highQ = -1e300, lowAlong = 1e300, highAlong = -1e300;

    void add(const ShadowAxes::Point& point) {
        lowQ = std::min(lowQ, point.q);
        highQ = std::max(highQ, point.q);
        lowAlong = std::min(lowAlong, point.along);
        highAlong = std::max(highAlong, point.along);
    }
    void addBox(const ShadowAxes& axes, glm::dvec2 low, glm::dvec2 high) {
        const ShadowAxes::Point middle = axes.from((low + high) * 0.5);
        const glm::dvec2 half = (high - low) * 0.5;
        const double along = axes.swapped ? half.x : half.y, across = axes.swapped ? half.y : half.x;
        const double q = across + std::abs(axes.k) * along;
        add({middle.q - q, middle.along - along});
        add({middle.q + q, middle.along + along});
    }
};

}  // namespace noonmark
