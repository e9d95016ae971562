#include "app/gui/view/panel/wall_view.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

CameraPose faceWall(CameraPose pose, glm::dvec3 place, std::optional<double> azimuthDeg) {
    constexpr double farthestViewM = 80, pitchTowardsWallDeg = 20;
    pose.target = place;
    pose.distanceM = std::min(pose.distanceM, farthestViewM);
    if (!azimuthDeg) return pose;
    pose.headingDeg = std::fmod(*azimuthDeg + 180, 360);
    pose.pitchDeg = pitchTowardsWallDeg;
    return pose;
}

}  // namespace noonmark
