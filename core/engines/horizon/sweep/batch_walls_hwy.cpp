#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/sweep/batch_walls_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/engines/horizon/sweep/block_sweep.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t maximum = BatchLanes::maximum;
constexpr float nearly = nearlyOfDistance, margin = roundingOfDistance;

// Slopes are computed in double: the narrower a wall appears, the more rounding of its ends' q affects its
// width. A vector of azimuths is one vector of floats, and one or two of doubles.
using D = LanesUpTo<float, maximum>;
using V = hn::Vec<D>;
using Doubles = LanesUpTo<double, hn::MaxLanes(D{})>;
constexpr D d;
constexpr Doubles dd;
constexpr std::size_t lanes = hn::MaxLanes(d), halves = lanes / hn::MaxLanes(dd);

/// The numbers of a vector of azimuths.
struct Wide {
    hn::Vec<Doubles> part[halves];
};

template <class Operation>
HWY_INLINE Wide forEachPart(const Operation& operation) {
    Wide result;
    for (std::size_t i = 0; i < halves; ++i) result.part[i] = operation(i);
    return result;
}

HWY_INLINE Wide load(const double* from) {
    return forEachPart([&](std::size_t i) HWY_ATTR { return hn::Load(dd, from + i * hn::MaxLanes(dd)); });
}

// A template, so that only one branch is compiled.
template <class To>
HWY_INLINE V roundTo(To to, const Wide& wide) {
    if constexpr (halves == 1) {
        return hn::DemoteTo(to, wide.part[0]);
    } else {
        const hn::Half<To> half;
        return hn::Combine(to, hn::DemoteTo(half, wide.part[1]), hn::DemoteTo(half, wide.part[0]));
    }
}
HWY_INLINE V round(const Wide& wide) { return roundTo(d, wide); }

/// Coordinate q of one end of a wall at each azimuth.
HWY_INLINE Wide endAlong(const Wide& k, const glm::dvec2& end) {
    return forEachPart([&](std::size_t i) HWY_ATTR {
        return hn::Sub(hn::Set(dd, end.x), hn::Mul(k.part[i], hn::Set(dd, end.y)));
    });
}

// Returns one bit per azimuth.
HWY_INLINE std::uint32_t findFacingAway(const Wide& low, const Wide& high) {
    std::uint32_t away = 0;
    for (std::size_t i = 0; i < halves; ++i)
        away |= bitsOfMask(dd, hn::Gt(low.part[i], high.part[i])) << (i * hn::MaxLanes(dd));
    return away;
}

HWY_INLINE V perRiseOf(const double* alongPerMetre, float topM) {
    const Wide per = load(alongPerMetre);
    const Wide rise =
        forEachPart([&](std::size_t i) HWY_ATTR { return hn::Mul(hn::Set(dd, double(topM)), per.part[i]); });
    return hn::Div(hn::Set(d, 1), round(rise));
}

HWY_INLINE std::uint32_t findRaisingFrom(std::size_t first, const BatchLanes& batch, const float* cots,
                                         const WallAhead& wall, WallInBatch& in) {
    const Wide k = load(batch.k + first), lows = endAlong(k, wall.low), highs = endAlong(k, wall.high);
    const V low = round(lows), high = round(highs), zero = hn::Zero(d),
            perRise = perRiseOf(batch.alongPerMetre + first, wall.topM);
    const V nearest = hn::Mul(hn::Set(d, wall.nearestAlong * nearly - margin), perRise);
    const auto across = hn::And(hn::Ge(hn::Add(low, hn::Load(d, batch.maxOff + first)), zero),
                                hn::Lt(hn::Add(high, hn::Load(d, batch.minOff + first)), zero));
    const auto above = hn::Gt(hn::Load(d, cots + first), nearest);
    const std::uint32_t may = bitsOfMask(d, hn::And(across, above)) & findFacingAway(lows, highs);
    if (may == 0) return 0;
    const auto deep = hn::Set(dd, wall.low.y - wall.high.y);
    const Wide slope = forEachPart(
        [&](std::size_t i) HWY_ATTR { return hn::Div(deep, hn::Sub(lows.part[i], highs.part[i])); });
    hn::Store(low, d, in.low + first);
    hn::Store(high, d, in.high + first);
    hn::Store(round(slope), d, in.slope + first);
    hn::Store(perRise, d, in.perRise + first);
    return may << first;
}

}  // namespace

unsigned findRaisingAzimuths(const BatchLanes& batch, const float* cots, const WallAhead& wall,
                             WallInBatch& in) {
    unsigned may = 0;
    for (std::size_t first = 0; first < maximum; first += lanes)
        may |= findRaisingFrom(first, batch, cots, wall, in);
    return may;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(findRaisingAzimuths);
unsigned findRaisingAzimuths(const BatchLanes& batch, const float* cots, const WallAhead& wall,
                             WallInBatch& in) {
    return NOONMARK_CALL(findRaisingAzimuths)(batch, cots, wall, in);
}

}  // namespace noonmark
#endif
