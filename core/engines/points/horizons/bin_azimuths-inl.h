// Azimuths in bins, for the kernels of points; compiled for each instruction set.
#if defined(NOONMARK_BIN_AZIMUTHS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NOONMARK_BIN_AZIMUTHS_INL_H
#undef NOONMARK_BIN_AZIMUTHS_INL_H
#else
#define NOONMARK_BIN_AZIMUTHS_INL_H
#endif

#include <algorithm>
#include <numbers>

#include "core/engines/points/horizons/bin_horizon.h"
#include "core/engines/points/horizons/obstacle_blocks.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

// For the eight obstacles of a block, or the eight boxes of a node.
using Eight = LanesUpTo<float, BoxTree::width>;
constexpr std::size_t lanesOfEight = hn::MaxLanes(Eight{});

// For neighbouring bins.
using RowOfBins = LanesUpTo<float, BinDirections::padding>;
constexpr int binsOfRow = int(hn::MaxLanes(RowOfBins{}));

/// Consecutive bins; those from SunBins::count on are beyond north. At most one turn.
struct BinRange {
    int first, last;
};

/// Calls `visit(first, last)` for the one or two parts that do not pass north.
template <class Visit>
HWY_INLINE void splitAtNorth(BinRange range, const Visit& visit) {
    constexpr int count = SunBins::count;
    if (range.first < count) visit(range.first, std::min(range.last, count - 1));
    if (range.last >= count) visit(std::max(range.first - count, 0), range.last - count);
}

/// The bins of the azimuths from one to another, in bins from north, clockwise, and at least one more on both
/// sides.
HWY_INLINE BinRange binsAround(float from, float to) {
    BinRange range{int(from) - 2, int(to) + 2};
    if (from > to) range.last += SunBins::count;
    if (range.first < 0) range.first += SunBins::count, range.last += SunBins::count;
    range.last = std::min(range.last, range.first + SunBins::count - 1);
    return range;
}

/// Azimuth in bins from north, clockwise, 0 to SunBins::count; a 500th of a bin uncertain. The arc tangent is
/// formula 4.4.49 of Abramowitz and Stegun, Handbook of Mathematical Functions (1e-5 rad).
HWY_INLINE hn::Vec<Eight> azimuthInBins(hn::Vec<Eight> x, hn::Vec<Eight> y) {
    constexpr Eight d;
    using V = hn::Vec<Eight>;
    const V wide = hn::Abs(x), tall = hn::Abs(y);
    const V maximum = hn::Max(hn::Max(wide, tall), hn::Set(d, 1e-30F));
    const V ratio = hn::Div(hn::Min(wide, tall), maximum), square = hn::Mul(ratio, ratio);
    V sum = hn::Set(d, 0.0208351F);
    for (const float term : {-0.0851330F, 0.1801410F, -0.3302995F, 0.9998660F})
        sum = hn::Add(hn::Mul(sum, square), hn::Set(d, term));
    constexpr auto pi = std::numbers::pi_v<float>;
    V angle = hn::Mul(sum, ratio);
    angle = hn::IfThenElse(hn::Gt(wide, tall), hn::Sub(hn::Set(d, pi / 2), angle), angle);
    angle = hn::IfThenElse(hn::Lt(y, hn::Zero(d)), hn::Sub(hn::Set(d, pi), angle), angle);
    angle = hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, 2 * pi), angle), angle);
    return hn::Mul(angle, hn::Set(d, float(SunBins::count) / (2 * pi)));
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
