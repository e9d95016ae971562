#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/city/city.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/receivers.h"

namespace noonmark::bench {

/// Shadow by the ray reference for single directions that belong to no period: bit k of a receiver's mask is
/// set if it is in shadow for direction k.
class RayMasks {
public:
    RayMasks(RayScene scene, const Receivers& receivers);
    /// With all buildings of the city.
    static Result<RayMasks> over(const City& city, const Receivers& receivers, const std::stop_token& stop);

    /// One mask for each of receivers.cells. At most 64 directions, unit vectors. Uses all cores.
    [[nodiscard]] std::vector<ShadowMask> of(std::span<const glm::dvec3> directions) const;

private:
    RayScene scene_;
    std::vector<glm::vec3> origins_;
};

}  // namespace noonmark::bench
