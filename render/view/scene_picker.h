#pragma once

#include "core/engines/ray/ray_scene.h"
#include "render/view/camera_pose.h"
#include "render/view/section_box.h"

namespace noonmark {

/// The object under a pixel.
struct Pick {
    glm::dvec3 position{0};
    std::optional<std::uint32_t> building;  ///< index into City::buildings; empty: the ground
    glm::vec3 normal{0, 0, 1};              ///< of the building's surface: a unit vector, outward
};

/// Intersects rays of the view with a city. Immutable, cheap to copy; a pick takes microseconds.
class ScenePicker {
public:
    ScenePicker() = default;  ///< flat ground without buildings
    ScenePicker(City city, RayScene scene);

    /// The first hit of the ray: a building or the ground. Empty above the horizon.
    [[nodiscard]] std::optional<Pick> pick(const ViewRay& ray) const;
    /// The first hit inside the box. A building that the box cuts is hit where the ray enters it.
    [[nodiscard]] std::optional<Pick> pick(const ViewRay& ray, const SectionBox& section) const;

    /// Where the ray hits the ground, ignoring buildings.
    [[nodiscard]] std::optional<glm::dvec3> ground(const ViewRay& ray) const;

    [[nodiscard]] double groundAt(glm::dvec2 point) const;

    /// The whole city, ready for rays; empty without a city.
    [[nodiscard]] const std::optional<RayScene>& scene() const { return scene_; }

private:
    [[nodiscard]] std::optional<std::uint32_t> findBuildingAround(const glm::dvec3& point) const;

    City city_;
    std::optional<RayScene> scene_;
    double lowM_ = 0;
    double highM_ = 0;
};

}  // namespace noonmark
