// Azimuths in bins, and a visit of the boxes of a tree that rise above a point's horizon; for the kernels of
// points, compiled for each instruction set.
#if defined(NOONMARK_BOX_VISIT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NOONMARK_BOX_VISIT_INL_H
#undef NOONMARK_BOX_VISIT_INL_H
#else
#define NOONMARK_BOX_VISIT_INL_H
#endif

#include <algorithm>
#include <glm/vec3.hpp>
#include <numbers>

#include "core/engines/points/horizons/bin_horizon.h"
#include "core/engines/points/horizons/obstacle_blocks.h"
#include "core/simd/cache_line.h"
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

/// The extreme azimuths of boxes, in bins: those of the corners beside which nothing of the box is seen. From
/// inside, all azimuths. Coordinates relative to the eye.
HWY_INLINE void seeSides(hn::Vec<Eight> lowX, hn::Vec<Eight> lowY, hn::Vec<Eight> highX, hn::Vec<Eight> highY,
                         float* from, float* to) {
    constexpr Eight d;
    const auto choose = [](auto mask, auto yes, auto no) { return hn::IfThenElse(mask, yes, no); };
    const auto zero = hn::Zero(d);
    const auto north = hn::Gt(lowY, zero), south = hn::Lt(highY, zero);
    const auto east = hn::Gt(lowX, zero), west = hn::Lt(highX, zero);
    const auto lowIsWest = hn::Lt(lowX, zero), highIsEast = hn::Gt(highX, zero);
    // Left and right as seen from the eye; a box to the north of it is seen by its western and eastern end.
    const auto leftX = choose(north, lowX, choose(south, highX, choose(east, lowX, highX)));
    const auto leftY = choose(north, choose(lowIsWest, lowY, highY),
                              choose(south, choose(highIsEast, highY, lowY), choose(east, highY, lowY)));
    const auto rightX = choose(north, highX, choose(south, lowX, choose(east, lowX, highX)));
    const auto rightY = choose(north, choose(highIsEast, lowY, highY),
                               choose(south, choose(lowIsWest, highY, lowY), choose(east, lowY, highY)));
    const auto outside = hn::Or(hn::Or(north, south), hn::Or(east, west));
    const auto all = hn::Set(d, float(SunBins::count - 1));
    hn::Store(hn::IfThenElseZero(outside, azimuthInBins(leftX, leftY)), d, from);
    hn::Store(choose(outside, azimuthInBins(rightX, rightY), all), d, to);
}

/// Calls a function for the leaves of a tree that rise above a point's horizon, roughly from near to far. The
/// function may raise the horizon: what lies behind is then left out by its box.
class BoxVisit {
public:
    /// `horizon`: tangents of the bins, BinTangents; `eye` in local metres.
    BoxVisit(const BoxTree& tree, glm::vec3 eye, const float* horizon)
        : tree_(tree), eye_(eye), horizon_(horizon) {}

    /// `visit(leaf)`: index in BoxTree::leaves(). `prefetch(leaf)`: it may be visited soon.
    template <class Visit, class Prefetch>
    HWY_INLINE void visitLeaves(const Visit& visit, const Prefetch& prefetch) {
        if (tree_.nodes().empty()) return;
        openNode(tree_.nodes().front(), prefetch);
        while (count_ > 0) {
            const Box box = unvisited_[--count_];
            if (!anyBelow(box.bins, box.highestTan)) continue;
            if ((box.child & BoxTree::leafBit) != 0)
                visit(box.child & ~BoxTree::leafBit);
            else
                openNode(tree_.nodes()[box.child], prefetch);
        }
    }

private:
    /// A box that has yet to be visited.
    struct Box {
        float distance2 = 0;   // square of the level distance, square metres
        float highestTan = 0;  // nothing in it hides more
        BinRange bins{};
        std::uint32_t child = 0;
    };
    /// The boxes of a node as the eye sees them; azimuths in bins.
    struct Seen {
        HWY_ALIGN float distance2[BoxTree::width], highestTan[BoxTree::width], from[BoxTree::width],
            to[BoxTree::width];
    };

    HWY_INLINE void see(const BoxTree::Node& node, Seen& seen) const {
        constexpr Eight d;
        const auto zero = hn::Zero(d);
        for (std::size_t i = 0; i < BoxTree::width; i += lanesOfEight) {
            const auto lowX = hn::Sub(hn::LoadU(d, &node.lowX[i]), hn::Set(d, eye_.x));
            const auto lowY = hn::Sub(hn::LoadU(d, &node.lowY[i]), hn::Set(d, eye_.y));
            const auto highX = hn::Sub(hn::LoadU(d, &node.highX[i]), hn::Set(d, eye_.x));
            const auto highY = hn::Sub(hn::LoadU(d, &node.highY[i]), hn::Set(d, eye_.y));
            const auto height = hn::Sub(hn::LoadU(d, &node.topZ[i]), hn::Set(d, eye_.z));
            const auto x = hn::Max(zero, hn::Max(lowX, hn::Neg(highX)));
            const auto y = hn::Max(zero, hn::Max(lowY, hn::Neg(highY)));
            const auto distance2 = hn::Add(hn::Mul(x, x), hn::Mul(y, y));
            const auto rounded = hn::Mul(height, hn::Set(d, 1.0001F));  // up, so that nothing is left out
            const auto tan = hn::IfThenElse(hn::Gt(distance2, zero), hn::Div(rounded, hn::Sqrt(distance2)),
                                            hn::Set(d, BinDirections::always));
            hn::Store(distance2, d, seen.distance2 + i);
            hn::Store(hn::IfThenElseZero(hn::Gt(height, zero), tan), d, seen.highestTan + i);
            seeSides(lowX, lowY, highX, highY, seen.from + i, seen.to + i);
        }
    }

    // The nearest of its boxes will be visited next.
    template <class Prefetch>
    HWY_INLINE void openNode(const BoxTree::Node& node, const Prefetch& prefetch) {
        Seen seen;
        see(node, seen);
        const std::size_t before = count_;
        for (std::size_t i = 0; i < BoxTree::width; ++i) {
            if (seen.highestTan[i] <= 0) continue;
            const Box box{seen.distance2[i], seen.highestTan[i], binsAround(seen.from[i], seen.to[i]),
                          node.child[i]};
            if (!anyBelow(box.bins, box.highestTan)) continue;
            prefetchChild(box.child, prefetch);
            std::size_t place = count_++;
            for (; place > before && unvisited_[place - 1].distance2 < box.distance2; --place)
                unvisited_[place] = unvisited_[place - 1];
            unvisited_[place] = box;
        }
    }

    template <class Prefetch>
    HWY_INLINE void prefetchChild(std::uint32_t child, const Prefetch& prefetch) const {
        if ((child & BoxTree::leafBit) != 0) return prefetch(child & ~BoxTree::leafBit);
        prefetchLines(&tree_.nodes()[child]);
    }

    // May read bins beyond the last of the range: at worst, a box is visited in vain.
    HWY_INLINE bool anyBelow(BinRange range, float tan) const {
        constexpr RowOfBins d;
        const auto limit = hn::Set(d, tan);
        bool any = false;
        splitAtNorth(range, [&](int first, int last) {
            for (int bin = first; bin <= last && !any; bin += binsOfRow)
                any = !hn::AllFalse(d, hn::Lt(hn::LoadU(d, horizon_ + bin), limit));
        });
        return any;
    }

    const BoxTree& tree_;
    glm::vec3 eye_;
    const float* horizon_;
    std::size_t count_ = 0;
    Box unvisited_[BoxTree::maxUnvisited];
};

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
