#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "render/view/camera_pose.h"

namespace noonmark {

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
