#pragma once

#include <array>

#include "core/receivers/points/glazing_pane.h"

namespace noonmark {

/// The rectangle of a window that is a point: 1 x 1.2 m.
inline constexpr PaneSize defaultPane{{-0.5, -0.6}, {0.5, 0.6}};

/// The corners of a pane in local metres, 3 cm in front of its wall, counterclockwise seen from in front.
/// `normal`: a unit vector, outward. The size must be known.
inline std::array<glm::vec3, 4> computePaneCorners(glm::dvec3 middle, glm::dvec3 normal, PaneSize pane) {
    constexpr double inFrontM = 0.03;
    const PaneAxes axes = findPaneAxes(normal);
    const auto corner = [&](double right, double up) {
        return glm::vec3(middle + inFrontM * normal + right * axes.along + up * axes.up);
    };
    return {corner(pane.low.x, pane.low.y), corner(pane.high.x, pane.low.y), corner(pane.high.x, pane.high.y),
            corner(pane.low.x, pane.high.y)};
}

}  // namespace noonmark
