#pragma once

#include <glm/vec4.hpp>
#include <stop_token>
#include <vector>

#include "core/engines/depths/caster_faces.h"

namespace noonmark {

/// The part of space whose points are looked up in a map, local metres.
struct LitSpace {
    Box2 box;
    float lowM = 0;
    float highM = 0;  ///< >= lowM
};

/// What the sun does not see at one moment: depths along its direction, for drawing shadows on any surface.
/// An approximation for the eye: the edge of a shadow is off by up to a texel.
struct SunDepthMap {
    static constexpr int minSize = 16, maxSize = 8192;

    glm::dvec3 towardsSun{0, 0, 1};  ///< unit vector
    /// Scalar products with (x, y, z, 1) of a point give its column, row and height towards the sun, metres.
    /// Texel (column, row) has its centre at whole numbers.
    glm::dvec4 column{0}, row{0}, height{0};
    int size = 0;              ///< texels a side
    double texelM = 0;         ///< the longer side of a texel, metres across the sun's direction
    std::vector<float> depth;  ///< row-major; the height of the surface that shades the points below it;
                               ///< -1e30 where there is none
    /// The same for crowns in leaf and for bare ones, which take a part of the sun; empty: there are none.
    std::vector<float> crowns, bareCrowns;

    /// Whether the point lies in shadow: something in its texel is closer to the sun by more than `biasM`.
    /// False outside of the map.
    [[nodiscard]] bool shades(glm::dvec3 point, double biasM) const;
};

/// Draws the map that covers `space`, from the faces that the sun does not see. Occluders outside of the
/// space count too. `size`: 16 to 8192. `towardsSun`: above the horizon. Uses all cores: about 0.1 s for a
/// million faces. Returns soon after a stop request with an incomplete map; the caller must check the token.
SunDepthMap drawSunDepths(const CasterFaces& faces, glm::dvec3 towardsSun, const LitSpace& space, int size,
                          const std::stop_token& stop = {});

}  // namespace noonmark
