#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/points/horizons/bin_directions.h"
#include "core/engines/points/horizons/range_bounds.h"

namespace noonmark {

/// Suns in time order, in packets of up to 32 whose bins lie in one window; arrays for kernels.
struct SunPackets {
    static constexpr std::size_t size = 32;
    // One entry a step, and `size` more, which kernels may read.
    std::vector<std::uint16_t> bin;
    std::vector<float> tan;
    // One entry a packet, and up to 15 more.
    std::vector<std::int32_t> window;  ///< of BinRanges
    std::vector<float> lowestTan, highestTan;
};

/// One bit a packet, in words of 64: all of its suns are hidden, or none is. Where both bits are 0, some are,
/// or the bounds do not tell.
struct PacketBits {
    std::vector<std::uint64_t> hidden, lit;
};
void classifyPackets(const SunPackets& packets, const RangeBounds& bounds, PacketBits& bits);

/// Bit k: sun `first` + k is at or below the tangent of its bin. 32 suns.
std::uint32_t sunsUpTo(const SunPackets& packets, std::size_t first, const BinTangents& tangents);

}  // namespace noonmark
