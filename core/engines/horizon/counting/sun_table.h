#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// How many suns a horizon of each code hides, or by how many more in one period than in another. Codes count
/// from the lowest sun's; those beyond either end have the count at that end.
struct SunTable {
    const std::int16_t* counts;  ///< counts[0] to counts[last], and one more that is read but not used
    int lowest, last;

    [[nodiscard]] std::int16_t of(HorizonCode horizon) const {
        return counts[std::clamp(int(horizon) - lowest, 0, last)];
    }
};

/// Adds the count of each horizon to its sum. From 0.05 ns for a horizon at an end of the table, to 0.5 ns.
void addCounts(const SunTable& table, const HorizonCode* horizons, std::size_t count, std::int16_t* sums);

/// For a block's cells in `masks` (row by row), adds to the sums the count of the horizons `after` minus that
/// of `before`, modulo 2^32. Returns as bits the rows with sums that changed. 20 ns per row with such cells.
std::uint16_t addDifferences(const SunTable& table, const HorizonCode* before, const HorizonCode* after,
                             const ReceiverBlocks::Masks& masks, std::uint32_t* sums);

}  // namespace noonmark
