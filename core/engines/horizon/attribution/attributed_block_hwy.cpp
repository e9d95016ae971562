#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/attribution/attributed_block_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "core/engines/horizon/attribution/attributed_block.h"
#include "core/simd/kernel.h"

// After kernel.h.
#include "core/engines/horizon/sweep/edge_horizon-inl.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

/// The entries of some neighbouring cells.
struct AttributedCells {
    float *highest, *other;
    std::int32_t* building;
};

// The same comparisons as raiseUnevenBlock(), so the codes are the same.
HWY_INLINE void raiseCells(const EdgeHorizon& edge, std::int32_t building, const AttributedCells& cells) {
    constexpr EdgeCells d;
    constexpr hn::RebindToSigned<EdgeCells> di;
    const auto highest = hn::LoadU(d, cells.highest), other = hn::LoadU(d, cells.other);
    const auto before = hn::LoadU(di, cells.building), own = hn::Set(di, building);
    const auto higher = hn::And(edge.shaded, hn::Lt(edge.cot, highest));
    const auto second = hn::And(edge.shaded, hn::Lt(edge.cot, other));
    const auto ofOthers = hn::IfThenElse(higher, highest, hn::IfThenElse(second, edge.cot, other));
    const auto same = hn::RebindMask(d, hn::Eq(before, own));
    hn::StoreU(hn::IfThenElse(same, other, ofOthers), d, cells.other);
    hn::StoreU(hn::IfThenElse(higher, edge.cot, highest), d, cells.highest);
    hn::StoreU(hn::IfThenElse(hn::RebindMask(di, higher), own, before), di, cells.building);
}

}  // namespace

void raiseAttributedBlock(const WallOnBlock& wall, const BlockRows& rows, AttributedHorizons& horizons) {
    const RowRange range = findRows(wall, rows);
    for (auto row = std::size_t(range.first); row < std::size_t(range.end); ++row)
        EdgeBeforeRow(wall, rows, row)
            .forEachVector(horizons.grounds[row].values, [&](int place, const EdgeHorizon& edge) HWY_ATTR {
                raiseCells(
                    edge, wall.building,
                    {horizons.highest.rows[row].values + place, horizons.others.rows[row].values + place,
                     horizons.buildings[row].values + place});
            });
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

void clearBlock(const ReceiverBlocks::Masks& masks, AttributedHorizons& horizons) {
    clearBlock(masks, horizons.highest);
    horizons.others = horizons.highest;
    for (CacheLine<std::int32_t>& row : horizons.buildings) std::ranges::fill(row.values, -1);
}

NOONMARK_KERNEL(raiseAttributedBlock);
void raiseBlock(const WallOnBlock& wall, const BlockRows& rows, AttributedHorizons& horizons) {
    NOONMARK_CALL(raiseAttributedBlock)(wall, rows, horizons);
}

void toCodes(const AttributedHorizons& horizons, HorizonCode lowest, AttributedCodes& codes) {
    toCodes(horizons.highest, lowest, codes.codes);
    toCodes(horizons.others, lowest, codes.others);
    std::int32_t* to = codes.buildings;
    for (const CacheLine<std::int32_t>& row : horizons.buildings) to = std::ranges::copy(row.values, to).out;
}

}  // namespace noonmark
#endif
