#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/city/city.h"

namespace noonmark {

/// Where the sun may pass below a part that is no overhang: parts below it carry nearly all of it, and some
/// open air is left (settleParts, markOverhangs). Horizons count that air as solid, rays do not.
struct OpenBelow {
    Footprint piece;  ///< the open air in plan, local metres
    Box2 box;         ///< of it
    float bottomM;    ///< underside of the part, local metres
    float partTopM;   ///< top of the part
};

/// The open air below these buildings' prisms. Gaps below meshes are not looked for. 10 ms for Midtown's 928
/// raised parts.
std::vector<OpenBelow> findOpenBelow(const City& city, std::span<const std::uint32_t> buildings);

/// Whether an eye is in the open air itself: horizons count it as inside a solid, and miss what hides it
/// above.
bool isIn(const OpenBelow& open, glm::vec3 eye);

/// Bounds of some eyes, local metres.
struct EyeBox {
    glm::vec3 low{1e30F}, high{-1e30F};
};

/// How open air looks from anywhere in a box of eyes.
struct SeenOpenBelow {
    double azimuthRad;  ///< of its middle, from +y, clockwise
    double halfRad;     ///< to either side; pi: everywhere
    double topTan;  ///< nothing of the part is seen above this tangent; may be infinite. 0 if no eye looks up
                    ///< to the part's underside
};
SeenOpenBelow seeFrom(const OpenBelow& open, const EyeBox& eyes);

}  // namespace noonmark
