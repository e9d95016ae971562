#include "render/view/camera_pose.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace noonmark {

glm::dvec3 computeForward(const CameraPose& pose) {
    const double heading = glm::radians(pose.headingDeg);
    const double pitch = glm::radians(pose.pitchDeg);
    return {std::sin(heading) * std::cos(pitch), std::cos(heading) * std::cos(pitch), -std::sin(pitch)};
}

glm::dvec3 computeUp(const CameraPose& pose) {
    const double heading = glm::radians(pose.headingDeg);
    const double pitch = glm::radians(pose.pitchDeg);
    return {std::sin(heading) * std::sin(pitch), std::cos(heading) * std::sin(pitch), std::cos(pitch)};
}

glm::dvec3 computeRight(const CameraPose& pose) {
    const double heading = glm::radians(pose.headingDeg);
    return {std::cos(heading), -std::sin(heading), 0};
}

glm::dvec3 computeEye(const CameraPose& pose) {
    constexpr double parallelM =
        3000;  // farther away float32 would blur the faces of a picture of a few metres
    const double distanceM = pose.isParallel() ? parallelM + 2 * pose.distanceM : pose.distanceM;
    return pose.target - distanceM * computeForward(pose);
}

glm::dvec3 ViewBounds::centre() const {
    return {glm::dvec2(box.low + box.high) / 2.0, (double(topM) + double(groundM)) / 2};
}

double ViewBounds::radiusM() const {
    const glm::dvec3 diagonal{glm::dvec2(box.high - box.low), double(topM - groundM)};
    return std::max(1.0, glm::length(diagonal) / 2);
}

ClipRange computeClipRange(const CameraPose& pose, const ViewBounds& bounds) {
    const double toCentre = glm::length(bounds.centre() - computeEye(pose));
    // The ground extends beyond the city so that it fades out instead of showing an edge.
    const double farM = toCentre + 6 * bounds.radiusM();
    const double fromCity = toCentre - bounds.radiusM();
    return {std::max({0.5, fromCity * 0.5, pose.distanceM * 0.01}), farM};
}

}  // namespace noonmark
