#pragma once

#include "core/engines/ray/ray_scene.h"
#include "render/view/view_ray.h"

namespace noonmark {

/// What lies under a pixel.
struct Pick {
    glm::dvec3 position{0};
    std::optional<std::uint32_t> building;  ///< index in City::buildings; none: the ground
};

/// Rays of the view against a city. Immutable, cheap to copy; a pick takes microseconds.
class ScenePicker {
public:
    ScenePicker() = default;  ///< a flat ground without buildings
    ScenePicker(City city, RayScene scene);

    /// The first thing on the ray: a building, or the ground. None above the horizon.
    [[nodiscard]] std::optional<Pick> pick(const ViewRay& ray) const;

    /// The ground on the ray, as if no building stood before it.
    [[nodiscard]] std::optional<glm::dvec3> ground(const ViewRay& ray) const;

    [[nodiscard]] double groundAt(glm::dvec2 point) const;

    /// All of the city, ready for rays; none without a city.
    [[nodiscard]] const std::optional<RayScene>& scene() const { return scene_; }

private:
    City city_;
    std::optional<RayScene> scene_;
    double lowM_ = 0;
    double highM_ = 0;
};

}  // namespace noonmark
