#include "render/view/scene_picker.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace noonmark {

namespace {

// A view that has no size yet has no rays, and Embree ends the program at one that is no number.
bool isRay(const ViewRay& ray) {
    const glm::dvec3 sum = ray.origin + ray.direction;
    return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

}  // namespace

ScenePicker::ScenePicker(City city, RayScene scene) : city_(std::move(city)), scene_(std::move(scene)) {
    if (!city_.terrain) return;
    const auto [low, high] = std::ranges::minmax(city_.terrain->elevationM);
    lowM_ = low;
    highM_ = high;
}

double ScenePicker::groundAt(glm::dvec2 point) const { return double(noonmark::groundAt(city_, point)); }

std::optional<glm::dvec3> ScenePicker::ground(const ViewRay& ray) const {
    return findGroundHit(
        ray, [this](glm::dvec2 point) { return groundAt(point); }, lowM_, highM_);
}

std::optional<Pick> ScenePicker::pick(const ViewRay& ray) const {
    if (!isRay(ray)) return std::nullopt;
    std::optional<Pick> nearest;
    if (const auto point = ground(ray)) nearest = Pick{*point, {}};
    if (!scene_) return nearest;
    const auto hit = scene_->firstHit(glm::vec3(ray.origin), glm::vec3(ray.direction));
    if (!hit || !hit->building) return nearest;
    const bool before = !nearest || double(hit->distanceM) < glm::length(nearest->position - ray.origin);
    return before ? Pick{glm::dvec3(hit->position), hit->building, hit->normal} : nearest;
}

std::optional<Pick> ScenePicker::pick(const ViewRay& ray, const SectionBox& section) const {
    if (!isRay(ray)) return std::nullopt;
    const auto span = findSpan(section, ray);
    if (!span) return std::nullopt;
    const glm::dvec3 start = ray.origin + span->fromM * ray.direction;
    if (const auto cut = findBuildingAround(start)) return Pick{start, cut, glm::vec3(-ray.direction)};
    const auto hit = pick({start, ray.direction});
    return hit && contains(section, hit->position) ? hit : std::nullopt;
}

// Seen from inside, a roof faces away.
std::optional<std::uint32_t> ScenePicker::findBuildingAround(const glm::dvec3& point) const {
    const auto above = scene_ ? scene_->firstHit(glm::vec3(point), {0, 0, 1}) : std::nullopt;
    return above && above->normal.z > 0 ? above->building : std::nullopt;
}

}  // namespace noonmark
