#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace noonmark {

/// How the shadows of one azimuth run over the cells of a grid. Of its two axes `along` is the one nearer to
/// the shadows, turned so that they run towards higher `along`; `across` is the other. q = across - k along
/// is the same for all points of one shadow. Unit: cells, cell centres at whole numbers.
struct ShadowAxes {
    /// `away`: unit vector that shadows run along.
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

    /// Whether going from (across, along) to (x, y) turns the plane over.
    [[nodiscard]] bool mirrored() const { return swapped != (sign < 0); }

    bool swapped;             ///< `along` is x
    double sign;              ///< of the axis: 1 or -1
    double alongPerDistance;  ///< of a distance along the azimuth, the part along `along`: 0.7 to 1
    double k;                 ///< -1 to 1
};

/// What some points span in the axes of one azimuth.
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
