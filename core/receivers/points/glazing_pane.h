#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace noonmark {

/// Two unit vectors in the plane of a pane: level, and upward along the steepest line. Of a level pane they
/// are +x and +y.
struct PaneAxes {
    glm::dvec3 along, up;
};
inline PaneAxes findPaneAxes(glm::dvec3 normal) {
    const double level = std::hypot(normal.x, normal.y);
    if (level < 1e-3) return {{1, 0, 0}, {0, 1, 0}};
    const glm::dvec3 along(-normal.y / level, normal.x / level, 0);
    return {along, glm::cross(normal, along)};
}

/// The rectangle around a pane, in its axes: metres from the receiver in its middle.
struct PaneSize {
    glm::dvec2 low{0}, high{0};  ///< (along, up); low is 0 or less, high 0 or more
    [[nodiscard]] bool isKnown() const { return high.x > low.x && high.y > low.y; }
    [[nodiscard]] double widthM() const { return high.x - low.x; }
    bool operator==(const PaneSize&) const = default;
};

/// What a file states about a window besides its place.
struct GlazingFacts {
    PaneSize pane;               ///< not known of windows that are points
    std::string room, dwelling;  ///< names; empty: not stated
};

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
