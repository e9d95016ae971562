#include "render/camera_control.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace noonmark {

namespace {

constexpr double degreesPerWidth = 180;
constexpr double margin = 1.08;

double tanHalfWidth(const ViewLens& lens) {
    return std::tan(glm::radians(lens.verticalDeg) / 2) * lens.widthPx / lens.heightPx;
}

double wrapped(double degrees) { return degrees - 360 * std::floor(degrees / 360); }

bool eyeIsClear(const CameraPose& pose, const GroundHeight& ground) {
    const glm::dvec3 eye = eyeOf(pose);
    return eye.z >= ground({eye.x, eye.y}) + CameraLimits::clearanceM;
}

}  // namespace

CameraLimits limitsFor(const ViewBounds& bounds) {
    CameraLimits limits;
    limits.furthestM = 6 * bounds.radiusM();
    limits.nearestM = std::min(5.0, limits.furthestM / 10);
    const auto border = float(bounds.radiusM() / 2);
    limits.box = {bounds.box.low - border, bounds.box.high + border};
    return limits;
}

CameraPose wholeCity(const ViewBounds& bounds, const ViewLens& lens) {
    CameraPose pose;
    pose.target = {bounds.centre().x, bounds.centre().y, double(bounds.groundM)};
    pose.pitchDeg = 38;
    const glm::dvec2 half = glm::dvec2(bounds.box.high - bounds.box.low) / 2.0;
    const double tanHalfHeight = std::tan(glm::radians(lens.verticalDeg) / 2);
    // Width at the near edge of the box; height as the slanting view shortens it.
    const double forWidth = half.x / tanHalfWidth(lens) + half.y * std::cos(glm::radians(pose.pitchDeg));
    const double forHeight = half.y * std::sin(glm::radians(pose.pitchDeg)) / tanHalfHeight +
                             half.y * std::cos(glm::radians(pose.pitchDeg));
    pose.distanceM =
        std::max({20.0, forWidth * 0.92, forHeight * 0.98, double(bounds.topM - bounds.groundM)});
    return pose;
}

CameraPose fromAbove(const Box2& box, double groundM, const ViewLens& lens) {
    const glm::dvec2 half = glm::dvec2(box.high - box.low) / 2.0;
    CameraPose pose;
    pose.target = {glm::dvec2(box.low + box.high) / 2.0, groundM};
    pose.pitchDeg = 90;
    const double tanHalfHeight = std::tan(glm::radians(lens.verticalDeg) / 2);
    pose.distanceM = margin * std::max({10.0, half.y / tanHalfHeight, half.x / tanHalfWidth(lens)});
    return pose;
}

CameraPose orbited(const CameraPose& pose, glm::dvec2 dragPx, const ViewLens& lens) {
    CameraPose turned = pose;
    turned.headingDeg = wrapped(pose.headingDeg + dragPx.x * degreesPerWidth / lens.widthPx);
    turned.pitchDeg = std::clamp(pose.pitchDeg + dragPx.y * degreesPerWidth / lens.widthPx,
                                 CameraLimits::lowestPitchDeg, 90.0);
    return turned;
}

CameraPose panned(const CameraPose& pose, glm::dvec2 fromPx, glm::dvec2 toPx, const ViewLens& lens) {
    const auto from = planeHit(rayThrough(pose, lens, fromPx), pose.target.z);
    const auto to = planeHit(rayThrough(pose, lens, toPx), pose.target.z);
    if (!from || !to) return pose;
    glm::dvec3 step = *from - *to;
    // Near the horizon a pixel is kilometres of ground: no more than a distance at a time.
    const double length = glm::length(step);
    if (length > pose.distanceM) step *= pose.distanceM / length;
    CameraPose there = pose;
    there.target += step;
    return there;
}

CameraPose zoomed(const CameraPose& pose, glm::dvec3 point, double factor) {
    CameraPose nearer = pose;
    nearer.target = point + (pose.target - point) * factor;
    nearer.distanceM = pose.distanceM * factor;
    return nearer;
}

CameraPose moved(const CameraPose& pose, double right, double ahead) {
    const double heading = glm::radians(pose.headingDeg);
    const glm::dvec3 northward{std::sin(heading), std::cos(heading), 0};
    CameraPose there = pose;
    there.target += pose.distanceM * (right * rightOf(pose) + ahead * northward);
    return there;
}

CameraPose keptAboveGround(CameraPose pose, const CameraLimits& limits, const GroundHeight& ground) {
    pose.target.x = std::clamp(pose.target.x, double(limits.box.low.x), double(limits.box.high.x));
    pose.target.y = std::clamp(pose.target.y, double(limits.box.low.y), double(limits.box.high.y));
    pose.target.z = ground({pose.target.x, pose.target.y});
    pose.distanceM = std::clamp(pose.distanceM, limits.nearestM, limits.furthestM);
    pose.pitchDeg = std::clamp(pose.pitchDeg, CameraLimits::lowestPitchDeg, 90.0);
    while (pose.pitchDeg < 90 && !eyeIsClear(pose, ground))
        pose.pitchDeg = std::min(90.0, pose.pitchDeg + 0.5);
    return pose;
}

}  // namespace noonmark
