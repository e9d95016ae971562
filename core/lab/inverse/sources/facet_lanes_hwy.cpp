#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lab/inverse/sources/facet_lanes_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/lab/inverse/lanes.h"
#include "core/lab/inverse/sources/projected_source_finder.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

using Doubles = LanesUpTo<double, 8>;
using Single = LanesUpTo<double, 1>;

template <class D>
HWY_INLINE void widenFrom(D d, int i, double minor, double slope, double* low, double* high) {
    const auto places = hn::Iota(d, double(i));
    const auto crossing = hn::Add(hn::Set(d, minor), hn::Mul(places, hn::Set(d, slope)));
    hn::StoreU(hn::Min(crossing, hn::LoadU(d, low + i)), d, low + i);
    hn::StoreU(hn::Max(crossing, hn::LoadU(d, high + i)), d, high + i);
}

/// The first whole positions at or beyond some positions, counted from lane 0.
template <class D>
HWY_INLINE auto findLanes(D d, const double* position, const LanePlaces& places, const int* bend) {
    const hn::Rebind<std::int32_t, D> di;
    const auto held = hn::Min(hn::Max(hn::Set(d, double(places.first)), hn::LoadU(d, position)),
                              hn::Set(d, double(places.end)));
    const auto whole = hn::DemoteTo(di, hn::Ceil(held));
    return hn::Sub(hn::Sub(whole, hn::Set(di, places.from)), hn::LoadU(di, bend));
}

template <class D>
HWY_INLINE void findFrom(D d, int i, const double* low, const double* high, const LanePlaces& places,
                         int* firstLane, int* endLane) {
    const hn::Rebind<std::int32_t, D> di;
    const int* const bend = places.bend + i;
    hn::StoreU(hn::Max(findLanes(d, low + i, places, bend), hn::Zero(di)), di, firstLane + i);
    hn::StoreU(hn::Min(findLanes(d, high + i, places, bend), hn::Set(di, Lanes::perBlock)), di, endLane + i);
}

}  // namespace

void widenRanges(double minor, double slope, int count, double* low, double* high) {
    constexpr Doubles d;
    constexpr int lanes = int(hn::MaxLanes(d));
    int i = 0;
    for (; i + lanes <= count; i += lanes) widenFrom(d, i, minor, slope, low, high);
    for (; i < count; ++i) widenFrom(Single{}, i, minor, slope, low, high);
}

void findLaneRanges(const double* low, const double* high, const LanePlaces& places, int count,
                    int* firstLane, int* endLane) {
    constexpr Doubles d;
    constexpr int lanes = int(hn::MaxLanes(d));
    int i = 0;
    for (; i + lanes <= count; i += lanes) findFrom(d, i, low, high, places, firstLane, endLane);
    for (; i < count; ++i) findFrom(Single{}, i, low, high, places, firstLane, endLane);
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(widenRanges);
void widen(double minor, double slope, int count, double* low, double* high) {
    NOONMARK_CALL(widenRanges)(minor, slope, count, low, high);
}

NOONMARK_KERNEL(findLaneRanges);
void findLanesBetween(const double* low, const double* high, const LanePlaces& places, int count,
                      int* firstLane, int* endLane) {
    NOONMARK_CALL(findLaneRanges)(low, high, places, count, firstLane, endLane);
}

}  // namespace noonmark
#endif
