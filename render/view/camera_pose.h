#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// Where the camera is and looks. Local metres; a value.
struct CameraPose {
    glm::dvec3 target{0};     ///< what it looks at and turns around, on the ground
    double distanceM = 1000;  ///< from the eye to the target, > 0
    double headingDeg = 0;    ///< azimuth of the view, clockwise from true north
    double pitchDeg = 45;     ///< how far it looks down: 0 level, 90 straight down
    bool operator==(const CameraPose&) const = default;
};

glm::dvec3 computeForward(const CameraPose& pose);  ///< unit vector from eye to target
glm::dvec3 computeUp(
    const CameraPose& pose);  ///< unit vector, up on the screen; well-defined straight down too
glm::dvec3 computeRight(const CameraPose& pose);
glm::dvec3 computeEye(const CameraPose& pose);

/// What the camera must show: the box of a city on the ground, and how high it stands.
struct ViewBounds {
    Box2 box;
    float topM = 0;
    float groundM = 0;  ///< lowest ground
    [[nodiscard]] glm::dvec3 centre() const;
    [[nodiscard]] double radiusM() const;  ///< of the ball around it, >= 1
};

/// Distances of the near and far plane: nothing of `bounds` is cut off, and depth keeps its precision.
struct ClipRange {
    double nearM = 1;
    double farM = 10000;
};
ClipRange computeClipRange(const CameraPose& pose, const ViewBounds& bounds);

}  // namespace noonmark
