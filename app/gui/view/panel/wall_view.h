#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "render/view/camera_pose.h"

namespace noonmark {

/// The pose that looks at a place from in front of its wall, from at most 80 m. `azimuthDeg`: that the wall
/// faces, from true north; none: the direction of the view stays.
CameraPose faceWall(CameraPose pose, glm::dvec3 place, std::optional<double> azimuthDeg);

}  // namespace noonmark
