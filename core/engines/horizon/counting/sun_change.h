#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// How many more suns of one bin a horizon hides in one period than in another. Of suns that both have
/// nothing is looked up: where hours change at the ends of a day the table is short.
class SunChange {
public:
    static constexpr std::size_t mostSuns = 32'767;  ///< that come, and that go

    /// Both ascending, at most mostSuns each; no sun is in both.
    SunChange(std::span<const HorizonCode> come, std::span<const HorizonCode> gone);

    /// No horizon hides more than so many more, or less.
    [[nodiscard]] int most() const { return most_; }

    /// Adds the change of each horizon to its sum. The same on every instruction set. From 0.05 ns a horizon
    /// that hides none or all that change, to 0.5 ns.
    void addTo(const HorizonCode* horizons, std::size_t count, std::int16_t* sums) const;

    /// Of a block's cells in `masks` (row by row) adds to the sums how much more the horizons of `after`
    /// change than those of `before`, modulo 2^32. Returns the rows, as bits, with sums that are others now.
    /// 20 ns a row with such cells.
    std::uint16_t addDifference(const HorizonCode* before, const HorizonCode* after,
                                const ReceiverBlocks::Masks& masks, std::uint32_t* sums) const;

private:
    void fill(std::span<const HorizonCode> come, std::span<const HorizonCode> gone);

    int lowest_ = 0, last_ = 0;  // a horizon's place is horizon - lowest_, 0 to last_
    int most_ = 0;
    std::vector<std::int16_t> counts_;  // of each place, and one more that is read over
};

/// What tells the suns of a bin from those that it had before; nothing where they are the same. Both
/// ascending.
std::vector<SunChange> findSunChanges(std::span<const HorizonCode> suns, std::span<const HorizonCode> before);

}  // namespace noonmark
