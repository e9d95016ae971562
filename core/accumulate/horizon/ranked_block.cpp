#include "core/accumulate/horizon/ranked_block.h"

#include <algorithm>
#include <iterator>

namespace noonmark {

namespace {

// The same sums as raiseBlock() of UnevenHorizons: codes are the same.
[[gnu::always_inline]] inline void raiseLine(const WallOnBlock& wall, float shift, float along,
                                             const Floats16& ground, Floats16& best, Ints16& building,
                                             Floats16& other) {
    EdgeHorizon edge;
    findHorizon(wall, shift, along, ground, edge);
    const Ints16 higher = edge.shaded & (edge.cot < best), foreign = building != wall.building;
    other = higher & foreign ? best : other;
    other = edge.shaded & ~higher & foreign & (edge.cot < other) ? edge.cot : other;
    best = higher ? edge.cot : best;
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
