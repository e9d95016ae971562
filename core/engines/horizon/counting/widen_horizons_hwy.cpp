#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/counting/widen_horizons_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/horizon/counting/run_decider.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

// Levels of steepness by which rounding moves a horizon off the edge of its neighbours.
constexpr float levelsOfRounding = 3;

using Levels = LanesUpTo<float, 16>;
using Codes = hn::Rebind<HorizonCode, Levels>;
using Wide = hn::RebindToSigned<Levels>;
constexpr Levels df;
constexpr Codes dc;
constexpr Wide dw;

HWY_INLINE hn::Vec<Levels> levelOf(hn::Vec<Codes> codes) {
    return hn::ConvertTo(df, hn::Sub(hn::PromoteTo(dw, codes), hn::Set(dw, int(noHorizon))));
}

HWY_INLINE hn::Vec<Levels> tangentOf(hn::Vec<Levels> level) {
    return hn::Div(level, hn::Sub(hn::Set(df, float(steepnessLevels)), level));
}

HWY_INLINE hn::Vec<Levels> levelOfTangent(hn::Vec<Levels> tan) {
    return hn::Div(hn::Mul(tan, hn::Set(df, float(steepnessLevels))), hn::Add(tan, hn::Set(df, 1.0F)));
}

HWY_INLINE hn::Mask<Codes> areOnEdge(hn::Vec<Codes> before, hn::Vec<Codes> own, hn::Vec<Codes> after,
                                     const EdgeShares& shares) {
    const auto tan = hn::Add(hn::Mul(hn::Set(df, shares.before), tangentOf(levelOf(before))),
                             hn::Mul(hn::Set(df, shares.after), tangentOf(levelOf(after))));
    const auto off = hn::Abs(hn::Sub(levelOfTangent(tan), levelOf(own)));
    const auto onEdge = hn::RebindMask(dw, hn::Le(off, hn::Set(df, levelsOfRounding)));
    return hn::MaskFromVec(hn::DemoteTo(dc, hn::VecFromMask(dw, onEdge)));
}

}  // namespace

void findHighest(const HorizonsBeside& of, RunLanes& highest) {
    for (std::size_t i = 0; i < lanesPerPart; i += hn::MaxLanes(dc)) {
        const auto beside = hn::Max(hn::Load(dc, of.before.values + i), hn::Load(dc, of.after.values + i));
        hn::Store(hn::Max(hn::Load(dc, of.own.values + i), beside), dc, highest.values + i);
    }
}

void boundOffEdge(const HorizonsBeside& of, const EdgeShares& shares, RunLanes& lowest, RunLanes* highest) {
    const auto none = hn::Set(dc, noHorizon), every = hn::Set(dc, everyHorizon);
    for (std::size_t i = 0; i < lanesPerPart; i += hn::MaxLanes(dc)) {
        const auto before = hn::Load(dc, of.before.values + i), own = hn::Load(dc, of.own.values + i),
                   after = hn::Load(dc, of.after.values + i);
        const auto onEdge = areOnEdge(before, own, after, shares);
        hn::Store(hn::IfThenElse(onEdge, hn::Min(own, hn::Min(before, after)), none), dc, lowest.values + i);
        if (highest == nullptr) continue;
        const auto high = hn::Load(dc, highest->values + i);
        hn::Store(hn::IfThenElse(onEdge, high, every), dc, highest->values + i);
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(findHighest);
void findHighest(const HorizonsBeside& of, RunLanes& highest) { NOONMARK_CALL(findHighest)(of, highest); }

NOONMARK_KERNEL(boundOffEdge);
void boundOffEdge(const HorizonsBeside& of, const EdgeShares& shares, RunLanes& lowest, RunLanes* highest) {
    NOONMARK_CALL(boundOffEdge)(of, shares, lowest, highest);
}

}  // namespace noonmark
#endif
