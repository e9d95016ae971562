#include "core/engines/ray/visible_surface.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

#include "core/base/units.h"

namespace noonmark {

namespace {

constexpr int maxPixels = 16384;

struct PointSeen {
    glm::vec3 position{};
    glm::vec3 normal{};
    bool any = false;
};

Result<void> check(const PixelCamera& camera) {
    const auto inRange = [](int pixels) { return pixels >= 1 && pixels <= maxPixels; };
    if (!inRange(camera.widthPx) || !inRange(camera.heightPx))
        return failure(
            fmt::format("A picture of {} x {} pixels is out of range", camera.widthPx, camera.heightPx),
            "view", fmt::format("Choose 1 to {} pixels a side", maxPixels));
    if (!(camera.heightM >= 0 && camera.heightM < 1e7))
        return failure(fmt::format("A picture {} m high is out of range", camera.heightM), "view",
                       "Choose a height between 0 and 10000 km");
    if (!(camera.verticalDeg > 0 && camera.verticalDeg < 180))
        return failure(fmt::format("An angle of view of {} degrees is out of range", camera.verticalDeg),
                       "view", "Choose more than 0 and less than 180 degrees");
    return {};
}

std::optional<double> distanceToGround(glm::dvec3 origin, glm::dvec3 direction) {
    const double distance = -origin.z / direction.z;
    if (direction.z == 0 || !(distance > 0)) return std::nullopt;
    return distance;
}

// Moves the start of the line to where it enters the box; false if it misses the box.
bool enter(const VisibleBox& box, glm::dvec3& origin, const glm::dvec3& direction) {
    double fromM = 0, toM = 1e30;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = double(box.low[axis]) - origin[axis], high = double(box.high[axis]) - origin[axis];
        if (direction[axis] == 0 && (low > 0 || high < 0)) return false;
        if (direction[axis] == 0) continue;
        const auto [near, far] = std::minmax({low / direction[axis], high / direction[axis]});
        fromM = std::max(fromM, near);
        toM = std::min(toM, far);
    }
    origin += fromM * direction;
    return fromM <= toM;
}

bool isInside(const VisibleBox& box, glm::vec3 place) {
    constexpr float sharedM = 0.01F;  // surfaces in a side of the box belong to it
    return glm::all(glm::greaterThanEqual(place, box.low - sharedM)) &&
           glm::all(glm::lessThanEqual(place, box.high + sharedM));
}

PointSeen lookAlong(const RayScene& scene, bool flatGround, const LineOfSight& line) {
    const glm::dvec3 direction = glm::normalize(line.direction);
    const auto hit = scene.firstHit(glm::vec3(line.origin), glm::vec3(direction));
    const auto ground = flatGround ? distanceToGround(line.origin, direction) : std::nullopt;
    const double groundM = ground.value_or(1e30);
    if (hit && double(hit->distanceM) <= groundM) {
        const bool faces = glm::dot(hit->normal, glm::vec3(direction)) <= 0;
        return {hit->position, faces ? hit->normal : -hit->normal,
                double(hit->distanceM) <= farthestVisibleM};
    }
    if (groundM > farthestVisibleM) return {};
    const glm::vec3 place(line.origin + groundM * direction);
    return {{place.x, place.y, 0}, {0, 0, line.origin.z >= 0 ? 1 : -1}, true};
}

PointSeen lookAt(const RayScene& scene, bool flatGround, LineOfSight line,
                 const std::optional<VisibleBox>& section) {
    if (!section) return lookAlong(scene, flatGround, line);
    line.direction = glm::normalize(line.direction);
    if (!enter(*section, line.origin, line.direction)) return {};
    const auto hit = scene.firstHit(glm::vec3(line.origin), glm::vec3(line.direction));
    const bool cut = hit && hit->building && glm::dot(hit->normal, glm::vec3(line.direction)) > 0;
    const PointSeen seen = lookAlong(scene, flatGround, line);
    const bool shown =
        seen.any && isInside(*section, seen.position) && !(cut && seen.position == hit->position);
    return shown ? seen : PointSeen{};
}

VisibleSurface gatherPoints(const std::vector<PointSeen>& pixels, glm::vec3 eye) {
    VisibleSurface surface;
    surface.points.eye = eye;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].any) continue;
        surface.points.positions.push_back(pixels[i].position);
        surface.points.normals.push_back(pixels[i].normal);
        surface.pixel.push_back(std::uint32_t(i));
    }
    return surface;
}

}  // namespace

PixelCamera makeCamera(glm::dvec3 eye, glm::dvec3 target, double verticalDeg, int widthPx, int heightPx) {
    PixelCamera camera{.eye = eye, .verticalDeg = verticalDeg, .widthPx = widthPx, .heightPx = heightPx};
    camera.forward = glm::normalize(target - eye);
    const glm::dvec3 side = glm::cross(camera.forward, glm::dvec3(0, 0, 1));
    camera.right = glm::length(side) < 1e-9 ? glm::dvec3(1, 0, 0) : glm::normalize(side);
    camera.up = glm::cross(camera.right, camera.forward);
    return camera;
}

LineOfSight lineThrough(const PixelCamera& camera, int column, int row) {
    const double pixel = 1 / samplesPerMetre(camera, 1);
    const double right = (column + 0.5 - camera.widthPx * 0.5) * pixel;
    const double up = (camera.heightPx * 0.5 - row - 0.5) * pixel;
    const glm::dvec3 aside = right * camera.right + up * camera.up;
    if (camera.heightM > 0) return {camera.eye + aside, camera.forward};
    return {camera.eye, camera.forward + aside};
}

double samplesPerMetre(const PixelCamera& camera, double depthM) {
    if (camera.heightM > 0) return camera.heightPx / camera.heightM;
    return camera.heightPx / (2 * std::tan(Degrees{camera.verticalDeg / 2}.radians().value) * depthM);
}

Result<VisibleSurface> findVisibleSurface(const RayScene& scene, bool flatGround, const PixelCamera& camera,
                                          const std::stop_token& stop) {
    if (const auto ok = check(camera); !ok) return tl::make_unexpected(ok.error());
    std::vector<PointSeen> pixels(std::size_t(camera.widthPx) * std::size_t(camera.heightPx));
    tbb::parallel_for(tbb::blocked_range<int>(0, camera.heightPx, 8), [&](const auto& rows) {
        for (int row = rows.begin(); row < rows.end() && !stop.stop_requested(); ++row)
            for (int column = 0; column < camera.widthPx; ++column)
                pixels[std::size_t(row) * std::size_t(camera.widthPx) + std::size_t(column)] =
                    lookAt(scene, flatGround, lineThrough(camera, column, row), camera.section);
    });
    if (stop.stop_requested()) return cancelled();
    return gatherPoints(pixels, glm::vec3(camera.eye));
}

}  // namespace noonmark
