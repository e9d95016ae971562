#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// How the camera makes a picture.
enum class Projection {
    perspective,
    parallel,  ///< orthographic: parallel lines stay parallel, lengths across the view are to scale
};

/// Position and direction of the camera in local metres. A value.
struct CameraPose {
    glm::dvec3 target{
        0};  ///< point that the camera looks at and rotates around; in perspective on the ground
    /// From the eye to the target, > 0. In a parallel projection the picture shows as much as a perspective
    /// from there shows at the target.
    double distanceM = 1000;
    double headingDeg = 0;  ///< azimuth of the view, clockwise from true north
    double pitchDeg = 45;   ///< angle below the horizontal: 0 level, 90 straight down
    Projection projection = Projection::perspective;
    [[nodiscard]] bool isParallel() const { return projection == Projection::parallel; }
    bool operator==(const CameraPose&) const = default;
};

glm::dvec3 computeForward(const CameraPose& pose);  ///< unit vector from eye to target
glm::dvec3 computeUp(
    const CameraPose& pose);  ///< unit vector, up on the screen; also defined when looking straight down
glm::dvec3 computeRight(const CameraPose& pose);
/// In a parallel projection farther away than distanceM, so that what is high or near lies in front of it.
glm::dvec3 computeEye(const CameraPose& pose);

/// The extent that the camera must show: the bounding box of a city and its heights.
struct ViewBounds {
    Box2 box;
    float topM = 0;
    float groundM = 0;  ///< lowest ground
    [[nodiscard]] glm::dvec3 centre() const;
    [[nodiscard]] double radiusM() const;  ///< radius of the bounding sphere, >= 1
};

/// Distances of the near and far planes, chosen so that nothing of `bounds` is clipped and depth stays
/// precise.
struct ClipRange {
    double nearM = 1;
    double farM = 10000;
};
ClipRange computeClipRange(const CameraPose& pose, const ViewBounds& bounds);

/// The image of a camera; pixels count from the top left corner.
struct ViewLens {
    double verticalDeg = 40;  ///< vertical field of view
    double widthPx = 1;
    double heightPx = 1;
    bool operator==(const ViewLens&) const = default;
};

/// A ray in local metres; `direction` has unit length.
struct ViewRay {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, -1};
};

/// Length across the view that a pixel covers at a depth of so many metres in front of the eye, metres. In a
/// parallel projection the same everywhere.
double metresPerPixel(const CameraPose& pose, const ViewLens& lens, double depthM);
/// The same at the target.
double metresPerPixel(const CameraPose& pose, const ViewLens& lens);

/// The ray through a pixel, from the eye; in a parallel projection from a point beside the eye.
ViewRay makeRayThrough(const CameraPose& pose, const ViewLens& lens, glm::dvec2 pixel);

/// The pixel of a point; empty if the point is behind the eye.
std::optional<glm::dvec2> pixelOf(const CameraPose& pose, const ViewLens& lens, glm::dvec3 point);

/// Local z of the ground at a point.
using GroundHeight = std::function<double(glm::dvec2)>;

/// First intersection with the level plane at `z`; empty if the ray does not descend to it.
std::optional<glm::dvec3> findPlaneHit(const ViewRay& ray, double z);

/// First intersection with the ground, which lies between `lowM` and `highM`. Marches in steps of about one
/// terrain cell, then bisects. Exact for flat ground.
std::optional<glm::dvec3> findGroundHit(const ViewRay& ray, const GroundHeight& ground, double lowM,
                                        double highM);

}  // namespace noonmark
