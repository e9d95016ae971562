#pragma once

#include <array>
#include <cstdint>

namespace noonmark {

/// For each set of eight lanes, as bits: its lanes in ascending order, then the others. The first four
/// entries of the first sixteen are the same for four lanes.
inline constexpr auto packOrder = [] {
    std::array<std::array<std::uint8_t, 8>, 256> order{};
    for (unsigned set = 0; set < order.size(); ++set) {
        std::size_t next = 0;
        for (const unsigned wanted : {1U, 0U})
            for (unsigned lane = 0; lane < 8; ++lane)
                if ((set >> lane & 1U) == wanted) order[set][next++] = std::uint8_t(lane);
    }
    return order;
}();

}  // namespace noonmark
