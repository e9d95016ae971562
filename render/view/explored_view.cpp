#include "render/view/explored_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace noonmark {

namespace {

// As in resources/shaders/explored.inc.
constexpr double samePlaneM = 0.03;
constexpr double samePlaneShare = 0.25;  // share of the distance between samples

}  // namespace

double ExploredView::sampleM(double distanceM) const { return 1 / samplesPerMetre(camera, distanceM); }

std::optional<std::size_t> ExploredView::pointAt(glm::dvec3 place) const {
    const glm::dvec3 seen = place - camera.eye;
    const double depth = glm::dot(seen, camera.forward);
    if (depth <= 0) return std::nullopt;
    const double scale = samplesPerMetre(camera, depth);
    const double column = std::floor(camera.widthPx * 0.5 + scale * glm::dot(seen, camera.right));
    const double row = std::floor(camera.heightPx * 0.5 - scale * glm::dot(seen, camera.up));
    if (!(column >= 0 && column < camera.widthPx && row >= 0 && row < camera.heightPx)) return std::nullopt;
    const auto pixel = std::uint32_t(row) * std::uint32_t(camera.widthPx) + std::uint32_t(column);
    const auto found = std::ranges::lower_bound(surface->pixel, pixel);
    if (found == surface->pixel.end() || *found != pixel) return std::nullopt;
    const auto point = std::size_t(found - surface->pixel.begin());
    const glm::dvec3 apart = glm::dvec3(surface->points.positions[point]) - place;
    const double offSurface = std::abs(glm::dot(glm::dvec3(surface->points.normals[point]), apart));
    if (offSurface > samePlaneM + samePlaneShare * sampleM(depth)) return std::nullopt;
    return point;
}

PixelCamera makeExploredCamera(const CameraPose& pose, const ViewLens& lens, int spacingPx) {
    PixelCamera camera;
    camera.eye = computeEye(pose);
    camera.forward = computeForward(pose);
    camera.right = computeRight(pose);
    camera.up = computeUp(pose);
    camera.verticalDeg = lens.verticalDeg;
    if (pose.isParallel()) camera.heightM = metresPerPixel(pose, lens) * lens.heightPx;
    camera.heightPx = std::max(1, int(std::ceil(lens.heightPx / spacingPx)));
    camera.widthPx = std::max(1, int(std::ceil(lens.widthPx * camera.heightPx / lens.heightPx)));
    return camera;
}

}  // namespace noonmark
