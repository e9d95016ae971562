#pragma once

#include <cstdint>

#include "core/engines/ray/ray_scene.h"

namespace noonmark {

/// The rays of a block of 4 x 4 pixels, which one packet holds row by row from the top.
struct PixelBlock {
    static constexpr int sidePx = 4;
    glm::vec3 origin, direction;  ///< of the first pixel
    glm::vec3 right, down;        ///< added for each pixel further
    bool parallel = false;        ///< whether they are added to the origin instead of the direction
};

/// Directs the rays of a packet at the pixels of a block; its distances are left as they are.
void aimRays(const PixelBlock& block, HitPacket& packet);

/// Ends rays at the level plane `groundM` that reach it between `from` and `distance`. Bit k: ray k does.
std::uint32_t endAtGround(float groundM, HitPacket& packet);

/// The bits of each pixel (TracedPixel::bits) from the packet's hits. `ground`: see endAtGround(). `cut`:
/// surfaces that are seen from behind are cuts.
void packPixels(const HitPacket& packet, std::uint32_t ground, bool cut, std::uint32_t* bits);

/// Turns the rays of a packet with hits towards the sun (a unit vector), from the surface of each pixel, of
/// which `bits` has the normal. Pixels that face away from the sun or show the sky get an empty range. Bit k:
/// pixel k faces the sun.
std::uint32_t turnToSun(glm::vec3 towardsSun, const std::uint32_t* bits, HitPacket& packet);

}  // namespace noonmark
