#pragma once

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

}  // namespace noonmark
