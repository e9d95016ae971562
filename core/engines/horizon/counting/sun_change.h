#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// A lookup table for how many more suns of one bin a horizon hides in one period than in another. Suns
/// common to both periods need no entries, so the table is short if only the hours at the ends of a day
/// change.
class CountChange {
public:
    static constexpr std::size_t maxSuns = 32'767;  ///< limit for added suns, and for removed suns

    /// Both ascending, at most maxSuns each; no sun is in both.
    CountChange(std::span<const HorizonCode> added, std::span<const HorizonCode> removed);

    /// Largest absolute change of any horizon.
    [[nodiscard]] int maximum() const { return maximum_; }

    /// Adds the change of each horizon to its sum (addCounts).
    void addTo(const HorizonCode* horizons, std::size_t count, std::int16_t* sums) const;

    /// For a block's cells in `masks` (row by row), adds to the sums the change of the horizons `after` minus
    /// that of `before`, modulo 2^32. Returns as bits the rows with sums that changed (addDifferences).
    std::uint16_t addDifference(const HorizonCode* before, const HorizonCode* after,
                                const ReceiverBlocks::Masks& masks, std::uint32_t* sums) const;

private:
    void fill(std::span<const HorizonCode> added, std::span<const HorizonCode> removed);

    int lowest_ = 0, last_ = 0;  // a horizon's index is horizon - lowest_, from 0 to last_
    int maximum_ = 0;
    std::vector<std::int16_t> counts_;  // one per index, and one more that is read but not used
};

/// The differences between the suns of a bin and those it had before; empty if they are the same. Both
/// ascending.
std::vector<CountChange> findSunChanges(std::span<const HorizonCode> suns,
                                        std::span<const HorizonCode> before);

}  // namespace noonmark
