#include "core/accumulate/horizon/ranked_block.h"

#include <algorithm>
#include <iterator>

namespace noonmark {

namespace {

constexpr Floats16 places{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

// The same sums as raiseBlock() of UnevenHorizons: codes are the same.
[[gnu::always_inline]] inline void raiseLine(const WallOnBlock& wall, float shift, float along,
                                             const Floats16& ground, Floats16& best, Ints16& building,
                                             Floats16& other) {
    const Floats16 low = places + (wall.low - shift), high = places + (wall.high - shift);
    const Floats16 distance = (wall.along + along) - wall.slope * low;
    const Floats16 behind = distance > 0 ? distance : Floats16{};
    Floats16 steepness;
    findSteepness(wall, low, behind, ground, steepness);
    const Ints16 shaded = (low >= 0) & (high < 0) & (distance > wall.nearest);
    const Ints16 higher = shaded & (steepness > best), foreign = building != wall.building;
    other = higher & foreign ? best : other;
    other = shaded & ~higher & foreign & (steepness > other) ? steepness : other;
    best = higher ? steepness : best;
    building = higher ? Ints16{} + wall.building : building;
}

}  // namespace

void clearBlock(const ReceiverBlocks::Masks& masks, RankedHorizons& horizons) {
    BlockHorizons level;
    clearBlock(masks, level);
    std::ranges::copy(level.lines, horizons.lines);
    std::ranges::copy(level.lines, horizons.others);
    std::ranges::fill(horizons.buildings, Ints16{} - 1);
}

NOONMARK_EVERY_ISA
void raiseBlock(const WallOnBlock& wall, const BlockLines& lines, RankedHorizons& horizons) {
    const LineRange range = linesOf(wall, lines);
    for (int line = range.first; line < range.end; ++line)
        raiseLine(wall, lines.shifts[std::size_t(line)], lines.alongs[std::size_t(line)],
                  horizons.grounds[line], horizons.lines[line], horizons.buildings[line],
                  horizons.others[line]);
}

void codesOf(const RankedHorizons& horizons, HorizonCode lowest, RankedCodes& codes) {
    BlockHorizons some;
    std::ranges::copy(horizons.lines, some.lines);
    codesOf(some, lowest, codes.codes);
    std::ranges::copy(horizons.others, some.lines);
    codesOf(some, lowest, codes.others);
    std::copy_n(reinterpret_cast<const std::int32_t*>(horizons.buildings), ReceiverBlocks::cells,
                codes.buildings);
}

}  // namespace noonmark
