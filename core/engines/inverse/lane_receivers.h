#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/engines/inverse/lanes.h"
#include "core/receivers/receivers.h"
#include "core/simd/simd_lanes.h"

namespace noonmark {

/// Which receiver lies where on a block of lanes.
class LaneReceivers {
public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// Lanes will be over the receivers' grid with so many more cells on each side. 4 bytes a cell.
    LaneReceivers(const Receivers& receivers, int marginCells);

    /// numbers[major].values[lane]: the receiver's number in Receivers::cells, or none.
    void find(const Lanes& lanes, int block, std::vector<Line<std::uint32_t>>& numbers) const;

private:
    std::vector<std::uint32_t> ofCell_;  // of the wide grid
};

}  // namespace noonmark
