#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/engines/inverse/lanes.h"
#include "core/receivers/receivers.h"
#include "core/simd/cache_line.h"

namespace noonmark {

/// The receivers at the positions of a block of lanes.
class LaneReceivers {
public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// The lanes must be over the receivers' grid extended by `marginCells` on each side. 4 bytes per cell.
    LaneReceivers(const Receivers& receivers, int marginCells);

    /// numbers[major].values[lane]: the receiver's index in Receivers::cells, or none.
    void find(const Lanes& lanes, int block, std::vector<CacheLine<std::uint32_t>>& numbers) const;

private:
    std::vector<std::uint32_t> ofCell_;  // for each cell of the extended grid
};

}  // namespace noonmark
