#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/sun/sun_steps.h"

namespace noonmark {

/// Up to 16 directions as a structure of arrays, for SIMD.
struct alignas(64) DirectionPacket {
    static constexpr int capacity = 16;
    std::array<float, capacity> x{};  ///< unit vectors; lanes from `count` on repeat the last direction
    std::array<float, capacity> y{};
    std::array<float, capacity> z{};
    int count = 0;  ///< 1 to 16
};

/// Consecutive steps of the sun. A packet may span days, so that short days leave no lanes empty.
struct SunPacket {
    DirectionPacket directions;
    /// Bit k: step k begins a new run, because it is the first of its day or steps are missing before it.
    std::uint32_t starts = 0;
};

/// All steps in time order, 16 per packet; only the last may hold fewer. 256 bytes per packet.
std::vector<SunPacket> packSteps(const SunSteps& sun);

}  // namespace noonmark
