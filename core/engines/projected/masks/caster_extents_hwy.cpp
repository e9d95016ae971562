#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/projected/masks/caster_extents_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/projected/masks/caster_reach.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

namespace {

/// Tests casters, one in each lane.
template <class D>
class ReachTest {
public:
    using Doubles = hn::Vec<D>;

    HWY_INLINE ReachTest(D d, const CasterExtents& extents, const ReachLimits& limits)
        : d_(d),
          extents_(extents),
          limits_(limits),
          // The corners that are first and last across the shadows.
          firstX_((limits.acrossUnit.x > 0 ? extents.lowX : extents.highX).data()),
          firstY_((limits.acrossUnit.y > 0 ? extents.lowY : extents.highY).data()),
          lastX_((limits.acrossUnit.x > 0 ? extents.highX : extents.lowX).data()),
          lastY_((limits.acrossUnit.y > 0 ? extents.highY : extents.lowY).data()) {}

    [[nodiscard]] HWY_INLINE auto touch(std::size_t at) const {
        const Doubles top = load(extents_.topM.data(), at);
        const auto across =
            meets(limits_.across, top, alongAcross(firstX_, firstY_, at), alongAcross(lastX_, lastY_, at));
        const auto x = meets(limits_.x, top, load(extents_.lowX.data(), at), load(extents_.highX.data(), at));
        const auto y = meets(limits_.y, top, load(extents_.lowY.data(), at), load(extents_.highY.data(), at));
        return hn::And(across, hn::And(x, y));
    }

private:
    [[nodiscard]] HWY_INLINE Doubles load(const double* values, std::size_t at) const {
        return hn::LoadU(d_, values + at);
    }
    [[nodiscard]] HWY_INLINE Doubles alongAcross(const double* x, const double* y, std::size_t at) const {
        return hn::Add(hn::Mul(load(x, at), hn::Set(d_, limits_.acrossUnit.x)),
                       hn::Mul(load(y, at), hn::Set(d_, limits_.acrossUnit.y)));
    }
    [[nodiscard]] HWY_INLINE auto meets(const ReachLimits::Axis& axis, Doubles top, Doubles low,
                                        Doubles high) const {
        const Doubles from = hn::Add(low, hn::Mul(top, hn::Set(d_, axis.minimum))),
                      to = hn::Add(high, hn::Mul(top, hn::Set(d_, axis.maximum)));
        return hn::And(hn::Le(from, hn::Set(d_, axis.high)), hn::Ge(to, hn::Set(d_, axis.low)));
    }

    D d_;
    const CasterExtents& extents_;
    const ReachLimits& limits_;
    const double *firstX_, *firstY_, *lastX_, *lastY_;
};

template <class D>
HWY_INLINE std::uint64_t bitsOf(D d, const ReachTest<D>& test, std::size_t at) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, test.touch(at), bits);
    return bits[0];
}

}  // namespace

std::uint64_t findTouching(const CasterExtents& extents, std::size_t first, std::size_t count,
                           const ReachLimits& limits) {
    const hn::CappedTag<double, 8> d;
    const hn::CappedTag<double, 1> one;
    const std::size_t lanes = hn::Lanes(d), whole = count / lanes * lanes;
    const ReachTest together(d, extents, limits);
    const ReachTest single(one, extents, limits);
    std::uint64_t touching = 0;
    for (std::size_t i = 0; i < whole; i += lanes) touching |= bitsOf(d, together, first + i) << i;
    for (std::size_t i = whole; i < count; ++i) touching |= bitsOf(one, single, first + i) << i;
    return touching;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(findTouching);
std::uint64_t findTouching(const CasterExtents& extents, std::size_t first, std::size_t count,
                           const ReachLimits& limits) {
    return NOONMARK_CALL(findTouching)(extents, first, count, limits);
}

}  // namespace noonmark
#endif
