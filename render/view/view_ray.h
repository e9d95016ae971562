#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "render/view/camera_pose.h"

namespace noonmark {

/// The picture that a camera makes: pixels from the top left corner.
struct ViewLens {
    double verticalDeg = 40;  ///< angle of view from the bottom to the top edge
    double widthPx = 1;
    double heightPx = 1;
    bool operator==(const ViewLens&) const = default;
};

/// A ray in local metres; `direction` has unit length.
struct ViewRay {
    glm::dvec3 origin{0};
    glm::dvec3 direction{0, 0, -1};
};

/// The ray from the eye through a pixel.
ViewRay makeRayThrough(const CameraPose& pose, const ViewLens& lens, glm::dvec2 pixel);

/// Where a point appears; none when it lies behind the eye.
std::optional<glm::dvec2> pixelOf(const CameraPose& pose, const ViewLens& lens, glm::dvec3 point);

/// Local z of the ground at a point.
using GroundHeight = std::function<double(glm::dvec2)>;

/// Where a ray first meets the level plane at `z`; none when it does not go down to it.
std::optional<glm::dvec3> findPlaneHit(const ViewRay& ray, double z);

/// Where a ray first meets the ground, which lies between `lowM` and `highM`: marched in steps of about a
/// cell of terrain, then bisected. Exact where the ground is flat.
std::optional<glm::dvec3> findGroundHit(const ViewRay& ray, const GroundHeight& ground, double lowM,
                                        double highM);

}  // namespace noonmark
