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

namespace {

constexpr int marchSteps = 400;
constexpr int bisections = 30;

glm::dvec3 along(const ViewRay& ray, double distance) { return ray.origin + distance * ray.direction; }

bool below(const ViewRay& ray, double distance, const GroundHeight& ground) {
    const glm::dvec3 point = along(ray, distance);
    return point.z <= ground({point.x, point.y});
}

double bisected(const ViewRay& ray, const GroundHeight& ground, double above, double under) {
    for (int i = 0; i < bisections; ++i) {
        const double middle = (above + under) / 2;
        (below(ray, middle, ground) ? under : above) = middle;
    }
    return (above + under) / 2;
}

double halfHeight(const ViewLens& lens) { return std::tan(glm::radians(lens.verticalDeg) / 2); }

}  // namespace

double metresPerPixel(const CameraPose& pose, const ViewLens& lens, double depthM) {
    return 2 * halfHeight(lens) * (pose.isParallel() ? pose.distanceM : depthM) / lens.heightPx;
}

double metresPerPixel(const CameraPose& pose, const ViewLens& lens) {
    return metresPerPixel(pose, lens, pose.distanceM);
}

ViewRay makeRayThrough(const CameraPose& pose, const ViewLens& lens, glm::dvec2 pixel) {
    const double pixelM = metresPerPixel(pose, lens, 1);
    const double x = (pixel.x - lens.widthPx / 2) * pixelM;
    const double y = (lens.heightPx / 2 - pixel.y) * pixelM;
    const glm::dvec3 aside = x * computeRight(pose) + y * computeUp(pose);
    if (pose.isParallel()) return {computeEye(pose) + aside, computeForward(pose)};
    return {computeEye(pose), glm::normalize(computeForward(pose) + aside)};
}

std::optional<glm::dvec2> pixelOf(const CameraPose& pose, const ViewLens& lens, glm::dvec3 point) {
    const glm::dvec3 seen = point - computeEye(pose);
    const double depth = glm::dot(seen, computeForward(pose));
    if (depth <= 0) return std::nullopt;
    const double scale = 1 / metresPerPixel(pose, lens, depth);
    return glm::dvec2{lens.widthPx / 2 + scale * glm::dot(seen, computeRight(pose)),
                      lens.heightPx / 2 - scale * glm::dot(seen, computeUp(pose))};
}

std::optional<glm::dvec3> findPlaneHit(const ViewRay& ray, double z) {
    if (ray.direction.z == 0) return std::nullopt;
    const double distance = (z - ray.origin.z) / ray.direction.z;
    if (!(distance >= 0)) return std::nullopt;
    return along(ray, distance);
}

std::optional<glm::dvec3> findGroundHit(const ViewRay& ray, const GroundHeight& ground, double lowM,
                                        double highM) {
    const auto last = findPlaneHit(ray, lowM);
    if (!last || highM <= lowM) return last;
    const auto top = findPlaneHit(ray, highM);
    const double from = top ? glm::length(*top - ray.origin) : 0;
    const double to = glm::length(*last - ray.origin);
    double above = from;
    for (int i = 1; i <= marchSteps; ++i) {
        const double distance = from + (to - from) * i / marchSteps;
        if (below(ray, distance, ground)) return along(ray, bisected(ray, ground, above, distance));
        above = distance;
    }
    return last;
}

}  // namespace noonmark
