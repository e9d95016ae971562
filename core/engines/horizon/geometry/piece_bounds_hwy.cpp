#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/geometry/piece_bounds_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/horizon/geometry/bin_walls.h"
#include "core/engines/horizon/geometry/shadow_axes.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

// Margins for distances in cells; they exceed the rounding of bounds and of the block's own coordinates.
constexpr float nearly = nearlyOfDistance, margin = 2 * roundingOfDistance;
// Depth of a block plus depth of a piece, in cells, rounded up.
constexpr float depths = 33;

using D = LanesUpTo<float, PieceBounds::together>;
constexpr D d;

HWY_INLINE hn::Mask<D> findRaising(const PieceBounds::Arrays& of, const BlockQuery& sight) {
    const auto ahead = hn::Sub(hn::Set(d, sight.lowestAlong), hn::LoadU(d, of.highAlong));
    const auto distance = hn::Sub(hn::Mul(ahead, hn::Set(d, nearly)), hn::Set(d, margin));
    const auto aside =
        hn::Mul(hn::Max(hn::Zero(d), hn::Add(ahead, hn::Set(d, depths))), hn::Set(d, sight.spread));
    const auto right = hn::Gt(hn::Add(hn::LoadU(d, of.highQ), aside), hn::Set(d, sight.lowQ));
    const auto left = hn::Lt(hn::Sub(hn::LoadU(d, of.lowQ), aside), hn::Set(d, sight.highQ));
    const auto above = hn::Gt(hn::Mul(hn::LoadU(d, of.rise), hn::Set(d, sight.cot)), distance);
    return hn::And(hn::And(right, left), above);
}

}  // namespace

std::uint32_t findRaisingPieces(const PieceBounds::Arrays& of, const BlockQuery& sight) {
    std::uint32_t may = 0;
    for (unsigned i = 0; i < PieceBounds::together; i += unsigned(hn::MaxLanes(d)))
        may |= bitsOfMask(d, findRaising({of.lowQ + i, of.highQ + i, of.highAlong + i, of.rise + i}, sight))
               << i;
    return may;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

void PieceBounds::resize(std::size_t pieces) {
    for (std::vector<float>* of : {&lowQ_, &highQ_, &highAlong_, &rise_}) of->resize(pieces + together);
}

void PieceBounds::set(std::size_t piece, float lowQ, float highQ, float highAlong, float rise) {
    lowQ_[piece] = lowQ;
    highQ_[piece] = highQ;
    highAlong_[piece] = highAlong;
    rise_[piece] = rise;
}

NOONMARK_KERNEL(findRaisingPieces);
std::uint32_t PieceBounds::mayRaise(std::size_t first, std::size_t end, const BlockQuery& sight) const {
    const Arrays from{lowQ_.data() + first, highQ_.data() + first, highAlong_.data() + first,
                      rise_.data() + first};
    const std::uint32_t own = end - first < together ? (1U << (end - first)) - 1 : 0xFFFFU;
    return own & NOONMARK_CALL(findRaisingPieces)(from, sight);
}

}  // namespace noonmark
#endif
