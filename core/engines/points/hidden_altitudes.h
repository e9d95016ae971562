#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/engines/points/sky_obstacles.h"

namespace noonmark {

/// Altitudes that something hides at one azimuth, as tangents: those between low and high.
struct HiddenAltitudes {
    double lowTan = 0;
    double highTan = 0;  ///< infinite: up to the zenith
    bool operator==(const HiddenAltitudes&) const = default;
};

/// What a face hides at an azimuth above the point's level; none where it is not seen.
std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, double azimuth);
/// The same with (sine, cosine) of the azimuth, for many faces at one.
std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, glm::dvec2 direction);

/// Sorts the intervals and joins those that overlap.
void joinOverlaps(std::vector<HiddenAltitudes>& hidden);

}  // namespace noonmark
