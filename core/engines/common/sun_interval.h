#pragma once

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace noonmark {

/// A short section of the sun's path, as the accrual maps use it: the sun moves along the great circle from
/// `first` to `last` in equal angles, one step after the other (paper, section 4: the tan law). Unit vectors
/// towards the sun, above the horizon.
struct SunInterval {
    glm::dvec3 first{0, 0, 1};
    glm::dvec3 last{0, 0, 1};
    int steps = 1;  ///< 1 to 64

    /// Direction at step k of 0 .. steps - 1; `first` at step 0, `last` at step steps - 1.
    [[nodiscard]] glm::dvec3 at(int step) const {
        if (steps <= 1) return first;
        const double angle = std::atan2(glm::length(glm::cross(first, last)), glm::dot(first, last));
        if (angle < 1e-12) return first;
        const double share = double(step) / double(steps - 1);
        return (std::sin((1 - share) * angle) * first + std::sin(share * angle) * last) / std::sin(angle);
    }
};

/// Callbacks to show masks before their interval is finished. Called by the thread that calls shadeWatched().
struct MaskWatcher {
    std::function<bool()> wants;          ///< whether an intermediate state should be shown now; cheap
    std::function<void(int steps)> show;  ///< in `masks`, all steps before this one are final
};

}  // namespace noonmark
