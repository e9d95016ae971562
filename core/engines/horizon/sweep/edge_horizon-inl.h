// The horizon that an edge gives the cells of a row, compiled for each instruction set (core/simd/kernel.h).
#if defined(NOONMARK_EDGE_HORIZON_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NOONMARK_EDGE_HORIZON_INL_H
#undef NOONMARK_EDGE_HORIZON_INL_H
#else
#define NOONMARK_EDGE_HORIZON_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "core/engines/horizon/sweep/raise_block.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

/// Some neighbouring cells of a row. Edges of terrain are a cell or two wide, so vectors of more than eight
/// cells would mostly be empty.
using EdgeCells = LanesUpTo<float, ReceiverBlocks::side / 2>;
inline constexpr EdgeCells edgeCells;

struct EdgeHorizon {
    hn::Vec<EdgeCells> cot;      ///< infinite if the cell is above the edge
    hn::Mask<EdgeCells> shaded;  ///< whether the edge is before the cell
};

/// An edge before one row of a block.
class EdgeBeforeRow {
public:
    HWY_INLINE EdgeBeforeRow(const WallOnBlock& wall, const BlockRows& rows, std::size_t row)
        : wall_(wall), low_(wall.low - rows.shifts[row]), high_(wall.high - rows.shifts[row]) {
        distance_ = (wall.along + rows.alongs[row]) - wall.slope * low_;
    }

    /// Calls visit(place, horizon) for the cells that the edge may shade, vector by vector; `place`: of the
    /// vector's first cell.
    template <class Visit>
    HWY_INLINE void forEachVector(const float* ground, const Visit& visit) const {
        constexpr int side = ReceiverBlocks::side, lanes = int(hn::MaxLanes(edgeCells));
        const int first = placeFrom(low_), end = placeFrom(high_);
        for (int place = first; place < end; place += lanes) {
            const int from = std::min(place, side - lanes);
            visit(from, horizonOf(from, ground));
        }
    }

private:
    // The first cell of the row whose q is not below this one: 0 to 16.
    static int placeFrom(float q) {
        return int(std::ceil(std::clamp(-q, 0.0F, float(ReceiverBlocks::side))));
    }

    HWY_INLINE EdgeHorizon horizonOf(int place, const float* ground) const {
        constexpr EdgeCells d;
        const auto places = hn::Iota(d, float(place)), zero = hn::Zero(d);
        const auto q = hn::Add(places, hn::Set(d, low_));
        const auto rise = hn::Add(hn::Set(d, wall_.rise), hn::Mul(hn::Set(d, wall_.riseSlope), q));
        const auto over = hn::Max(hn::Sub(rise, hn::LoadU(d, ground + place)), zero);
        const auto perRise = hn::Div(hn::Set(d, 1), over);
        const auto cot = hn::Sub(hn::Mul(hn::Set(d, distance_), perRise),
                                 hn::Mul(hn::Mul(hn::Set(d, wall_.slope), perRise), places));
        const auto before = hn::And(hn::Ge(q, zero), hn::Lt(hn::Add(places, hn::Set(d, high_)), zero));
        const auto behind = hn::Gt(cot, hn::Mul(hn::Set(d, wall_.nearest), perRise));
        return {hn::IfThenElse(hn::Gt(cot, zero), cot, zero), hn::And(before, behind)};
    }

    const WallOnBlock& wall_;
    float low_, high_, distance_;
};

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
