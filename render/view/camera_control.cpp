#include "render/view/camera_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace noonmark {

namespace {

constexpr double degreesPerWidth = 180;
constexpr double margin = 1.08;
constexpr int framingRounds = 12;

double tanHalfWidth(const ViewLens& lens) {
    return std::tan(glm::radians(lens.verticalDeg) / 2) * lens.widthPx / lens.heightPx;
}

double wrapped(double degrees) { return degrees - 360 * std::floor(degrees / 360); }

// Few buildings are as high as the tallest one, so the view need only contain a part of that height.
std::array<glm::dvec3, 8> cornersOf(const ViewBounds& bounds) {
    std::array<glm::dvec3, 8> corners{};
    const double highM = bounds.groundM + 0.35 * double(bounds.topM - bounds.groundM);
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {i & 1 ? bounds.box.high.x : bounds.box.low.x,
                      i & 2 ? bounds.box.high.y : bounds.box.low.y, i & 4 ? highM : double(bounds.groundM)};
    return corners;
}

// One iteration towards a view that the points fill: centres them and zooms to their extent.
CameraPose framePoints(const CameraPose& pose, const std::array<glm::dvec3, 8>& points,
                       const ViewLens& lens) {
    glm::dvec2 low(1e30);
    glm::dvec2 high(-1e30);
    for (const glm::dvec3 point : points) {
        const auto pixel = pixelOf(pose, lens, point);
        if (!pixel) return zoom(pose, pose.target, 2);
        low = glm::min(low, *pixel);
        high = glm::max(high, *pixel);
    }
    const glm::dvec2 share = (high - low) / glm::dvec2(lens.widthPx, lens.heightPx);
    const CameraPose middle = pan(pose, (low + high) / 2.0, {lens.widthPx / 2, lens.heightPx / 2}, lens);
    return zoom(middle, middle.target, std::clamp(margin * std::max(share.x, share.y), 0.5, 2.0));
}

double minPitchDeg(const CameraPose& pose) { return pose.isParallel() ? 0 : CameraLimits::minPitchDeg; }

// The target of a view that is not nearly level moves along the line of sight down or up to the ground: in a
// parallel projection the picture stays the same.
constexpr double levelDeg = 10;
void slideToGround(CameraPose& pose, const GroundHeight& ground) {
    const glm::dvec3 forward = computeForward(pose);
    const double aboveM = pose.target.z - ground({pose.target.x, pose.target.y});
    pose.target -= forward * (aboveM / forward.z);
}

CameraPose keepParallelWithin(CameraPose pose, const CameraLimits& limits, const GroundHeight& ground) {
    if (pose.pitchDeg > levelDeg) slideToGround(pose, ground);
    pose.target.x = std::clamp(pose.target.x, double(limits.box.low.x), double(limits.box.high.x));
    pose.target.y = std::clamp(pose.target.y, double(limits.box.low.y), double(limits.box.high.y));
    const double lowM = std::min(limits.lowM, ground({pose.target.x, pose.target.y}));
    pose.target.z = std::clamp(pose.target.z, lowM, std::max(lowM, limits.highM));
    return pose;
}

bool eyeIsClear(const CameraPose& pose, const GroundHeight& ground) {
    const glm::dvec3 eye = computeEye(pose);
    return eye.z >= ground({eye.x, eye.y}) + CameraLimits::clearanceM;
}

}  // namespace

CameraLimits computeLimits(const ViewBounds& bounds) {
    CameraLimits limits;
    limits.lowM = double(bounds.groundM);
    limits.highM = double(bounds.topM);
    limits.furthestM = 6 * bounds.radiusM();
    limits.nearestM = std::min(5.0, limits.furthestM / 10);
    const auto border = float(bounds.radiusM() / 2);
    limits.box = {bounds.box.low - border, bounds.box.high + border};
    return limits;
}

CameraPose wholeCity(const ViewBounds& bounds, const ViewLens& lens) {
    CameraPose pose;
    pose.target = {bounds.centre().x, bounds.centre().y, double(bounds.groundM)};
    pose.pitchDeg = 40;
    pose.distanceM = 4 * bounds.radiusM();
    for (int i = 0; i < framingRounds; ++i) pose = framePoints(pose, cornersOf(bounds), lens);
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

CameraPose orbit(const CameraPose& pose, glm::dvec2 dragPx, const ViewLens& lens) {
    CameraPose turned = pose;
    turned.headingDeg = wrapped(pose.headingDeg + dragPx.x * degreesPerWidth / lens.widthPx);
    turned.pitchDeg =
        std::clamp(pose.pitchDeg + dragPx.y * degreesPerWidth / lens.widthPx, minPitchDeg(pose), 90.0);
    return turned;
}

CameraPose orbit(const CameraPose& pose, const glm::dvec3& pivot, glm::dvec2 dragPx, const ViewLens& lens) {
    CameraPose turned = orbit(pose, dragPx, lens);
    if (!pose.isParallel()) return turned;
    const glm::dvec3 aside = pivot - pose.target;
    turned.target = pivot - glm::dot(aside, computeRight(pose)) * computeRight(turned) -
                    glm::dot(aside, computeUp(pose)) * computeUp(turned);
    return turned;
}

CameraPose pan(const CameraPose& pose, glm::dvec2 fromPx, glm::dvec2 toPx, const ViewLens& lens) {
    if (pose.isParallel()) {
        const glm::dvec2 byM = (fromPx - toPx) * metresPerPixel(pose, lens);
        CameraPose moved = pose;
        moved.target += byM.x * computeRight(pose) - byM.y * computeUp(pose);
        return moved;
    }
    const auto from = findPlaneHit(makeRayThrough(pose, lens, fromPx), pose.target.z);
    const auto to = findPlaneHit(makeRayThrough(pose, lens, toPx), pose.target.z);
    if (!from || !to) return pose;
    glm::dvec3 step = *from - *to;
    // Near the horizon a pixel covers kilometres of ground: the step is limited to the distance to the
    // target.
    const double length = glm::length(step);
    if (length > pose.distanceM) step *= pose.distanceM / length;
    CameraPose there = pose;
    there.target += step;
    return there;
}

CameraPose zoom(const CameraPose& pose, glm::dvec3 point, double factor) {
    CameraPose nearer = pose;
    nearer.target = point + (pose.target - point) * factor;
    nearer.distanceM = pose.distanceM * factor;
    return nearer;
}

CameraPose moveCamera(const CameraPose& pose, double right, double ahead) {
    const double heading = glm::radians(pose.headingDeg);
    const glm::dvec3 northward =
        pose.isParallel() ? computeUp(pose) : glm::dvec3{std::sin(heading), std::cos(heading), 0};
    CameraPose there = pose;
    there.target += pose.distanceM * (right * computeRight(pose) + ahead * northward);
    return there;
}

CameraPose project(CameraPose pose, Projection projection, const GroundHeight& ground) {
    if (pose.projection == projection) return pose;
    if (pose.isParallel() && pose.pitchDeg > levelDeg) slideToGround(pose, ground);
    pose.projection = projection;
    return pose;
}

CameraPose keepAboveGround(CameraPose pose, const CameraLimits& limits, const GroundHeight& ground) {
    pose.distanceM = std::clamp(pose.distanceM, limits.nearestM, limits.furthestM);
    pose.pitchDeg = std::clamp(pose.pitchDeg, minPitchDeg(pose), 90.0);
    if (pose.isParallel()) return keepParallelWithin(pose, limits, ground);
    pose.target.x = std::clamp(pose.target.x, double(limits.box.low.x), double(limits.box.high.x));
    pose.target.y = std::clamp(pose.target.y, double(limits.box.low.y), double(limits.box.high.y));
    pose.target.z = ground({pose.target.x, pose.target.y});
    while (pose.pitchDeg < 90 && !eyeIsClear(pose, ground))
        pose.pitchDeg = std::min(90.0, pose.pitchDeg + 0.5);
    return pose;
}

}  // namespace noonmark
