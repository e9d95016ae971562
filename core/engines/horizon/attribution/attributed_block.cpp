#include "core/engines/horizon/attribution/attributed_block.h"

#include <algorithm>
#include <iterator>

namespace noonmark {

namespace {

// The same operations as raiseBlock() of UnevenHorizons, so the codes are the same.
[[gnu::always_inline]] inline void raiseLine(const WallOnBlock& wall, float shift, float along,
                                             const float* ground, float* best, std::int32_t* building,
                                             float* other) {
    EdgeHorizon edge;
    findHorizon(wall, shift, along, ground, edge);
    for (int i = 0; i < lanesPerVector; ++i) {
        const bool shaded = edge.shaded[i] != 0, foreign = building[i] != wall.building;
        const bool higher = shaded & (edge.cot[i] < best[i]);
        const float second = higher ? best[i] : (shaded & (edge.cot[i] < other[i])) ? edge.cot[i] : other[i];
        other[i] = foreign ? second : other[i];
        best[i] = higher ? edge.cot[i] : best[i];
        building[i] = higher ? wall.building : building[i];
    }
}

}  // namespace

void clearBlock(const ReceiverBlocks::Masks& masks, AttributedHorizons& horizons) {
    BlockHorizons level;
    clearBlock(masks, level);
    std::ranges::copy(level.lines, horizons.lines);
    std::ranges::copy(level.lines, horizons.others);
    std::ranges::fill(horizons.buildings, Ints16{} - 1);
}

NOONMARK_EVERY_ISA
void raiseBlock(const WallOnBlock& wall, const BlockRows& rows, AttributedHorizons& horizons) {
    const RowRange range = linesOf(wall, rows);
    for (int row = range.first; row < range.end; ++row)
        raiseLine(wall, rows.shifts[std::size_t(row)], rows.alongs[std::size_t(row)],
                  lanesOf(horizons.grounds[row]), lanesOf(horizons.lines[row]),
                  lanesOf(horizons.buildings[row]), lanesOf(horizons.others[row]));
}

void toCodes(const AttributedHorizons& horizons, HorizonCode lowest, AttributedCodes& codes) {
    BlockHorizons some;
    std::ranges::copy(horizons.lines, some.lines);
    toCodes(some, lowest, codes.codes);
    std::ranges::copy(horizons.others, some.lines);
    toCodes(some, lowest, codes.others);
    std::copy_n(reinterpret_cast<const std::int32_t*>(horizons.buildings), ReceiverBlocks::cells,
                codes.buildings);
}

}  // namespace noonmark
