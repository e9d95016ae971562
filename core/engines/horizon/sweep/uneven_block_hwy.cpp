#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/sweep/uneven_block_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/horizon/sweep/raise_block.h"
#include "core/simd/kernel.h"

// After kernel.h.
#include "core/engines/horizon/sweep/edge_horizon-inl.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t side = ReceiverBlocks::side;
using D = LanesUpTo<float, side>;
using V = hn::Vec<D>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(d);
constexpr float unreachable = 1e30F;

}  // namespace

void raiseUnevenBlock(const WallOnBlock& wall, const BlockRows& rows, UnevenHorizons& horizons) {
    const RowRange range = findRows(wall, rows);
    for (auto row = std::size_t(range.first); row < std::size_t(range.end); ++row)
        EdgeBeforeRow(wall, rows, row)
            .forEachVector(horizons.grounds[row].values, [&](int place, const EdgeHorizon& edge) HWY_ATTR {
                float* const at = horizons.rows[row].values + place;
                const auto horizon = hn::LoadU(edgeCells, at);
                const auto higher = hn::And(edge.shaded, hn::Lt(edge.cot, horizon));
                hn::StoreU(hn::IfThenElse(higher, edge.cot, horizon), edgeCells, at);
            });
}

void findNeed(const CacheLine<float>* cots, const CacheLine<float>* grounds, float lowest, BlockNeed& need) {
    const V upright = hn::Set(d, 1e-7F), never = hn::Set(d, unreachable);
    for (std::size_t row = 0; row < side; ++row)
        for (std::size_t place = 0; place < side; place += lanes) {
            const V seen = hn::Min(hn::Load(d, cots[row].values + place), hn::Set(d, lowest));
            hn::Store(hn::Div(hn::Set(d, 1), hn::Max(seen, upright)), d, need.tans[row].values + place);
            const V ground = hn::Load(d, grounds[row].values + place);
            const auto receiver = hn::Ge(seen, hn::Zero(d));
            hn::Store(hn::IfThenElse(receiver, ground, never), d, need.grounds[row].values + place);
        }
}

float findMinRise(const BlockNeed& need, const BlockRows& rows, float distance) {
    constexpr float rounding = 1e-3F;
    V minimum = hn::Set(d, unreachable);
    for (std::size_t row = 0; row < side; ++row) {
        const float behind = distance + rows.alongs[row];
        const float surely = behind > 0 ? std::max(0.0F, behind * (1 - 1e-5F) - 1e-2F) : 0;
        for (std::size_t place = 0; place < side; place += lanes) {
            const V rise = hn::Mul(hn::Load(d, need.tans[row].values + place), hn::Set(d, surely));
            minimum = hn::Min(minimum, hn::Add(hn::Load(d, need.grounds[row].values + place), rise));
        }
    }
    return hn::GetLane(hn::MinOfLanes(d, minimum)) - rounding;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

void setGrounds(const BlockGround& ground, float risePerMetre, CacheLine<float>* grounds) {
    for (std::size_t row = 0; row < ReceiverBlocks::side; ++row)
        for (std::size_t i = 0; i < ReceiverBlocks::side; ++i)
            grounds[row].values[i] = ground.rowsM == nullptr ? 0 : ground.rowsM[row].values[i] * risePerMetre;
}

NOONMARK_KERNEL(raiseUnevenBlock);
void raiseBlock(const WallOnBlock& wall, const BlockRows& rows, UnevenHorizons& horizons) {
    NOONMARK_CALL(raiseUnevenBlock)(wall, rows, horizons);
}

NOONMARK_KERNEL(findNeed);
void findNeed(const CacheLine<float>* cots, const CacheLine<float>* grounds, float lowest, BlockNeed& need) {
    NOONMARK_CALL(findNeed)(cots, grounds, lowest, need);
}

NOONMARK_KERNEL(findMinRise);
float findMinRise(const BlockNeed& need, const BlockRows& rows, float distance) {
    return NOONMARK_CALL(findMinRise)(need, rows, distance);
}

}  // namespace noonmark
#endif
