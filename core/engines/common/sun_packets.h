#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// Up to 16 directions side by side, as vector units want them.
struct alignas(64) DirectionPacket {
    static constexpr int capacity = 16;
    std::array<float, capacity> x{};  ///< unit vectors; lanes from `count` on hold the last direction again
    std::array<float, capacity> y{};
    std::array<float, capacity> z{};
    int count = 0;  ///< 1 to 16
};

/// Consecutive steps of the sun. Days share packets, so that short days leave no lanes empty.
struct SunPacket {
    DirectionPacket directions;
    std::uint32_t starts =
        0;  ///< bit k: step k begins a new run: it is the first of its day, or steps are missing before it
};

/// All steps in their order, 16 a packet; only the last may hold fewer. 256 bytes a packet.
std::vector<SunPacket> packSteps(const SunSteps& sun);

}  // namespace noonmark
