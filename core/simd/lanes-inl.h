// Helpers for vectors, compiled for each instruction set; included by kernel.h only.
#if defined(NOONMARK_SIMD_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef NOONMARK_SIMD_LANES_INL_H
#undef NOONMARK_SIMD_LANES_INL_H
#else
#define NOONMARK_SIMD_LANES_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/simd/pack_order.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The widest vector of T with at most `maximum` lanes; its number of lanes is a constant.
template <class T, std::size_t maximum>
using LanesUpTo = hn::CappedTag<T, maximum>;

/// The lanes whose bits are set; bit 0 belongs to lane 0. Bits beyond the last lane are ignored.
template <class D>
HWY_INLINE hn::Mask<D> maskOfBits(D d, std::uint32_t bits) {
#if HWY_TARGET == HWY_AVX3
    const auto bytes = bits;
    return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bytes));
#else
    const hn::RebindToUnsigned<D> du;
    using Word = hn::TFromD<decltype(du)>;
    const auto bit = hn::Shl(hn::Set(du, Word{1}), hn::Iota(du, Word{0}));
    return hn::RebindMask(d, hn::TestBit(hn::Set(du, Word(bits)), bit));
#endif
}

/// The lanes whose bits are set in memory; bit 0 of the first byte belongs to lane 0. Reads just the bytes
/// with bits for lanes. For at least eight lanes, in memory of a little-endian processor.
template <class D>
HWY_INLINE hn::Mask<D> loadMask(D d, const std::uint8_t* bits) {
    constexpr std::size_t bytes = hn::MaxLanes(D{}) / 8;
    static_assert(bytes == 1 || bytes == 2 || bytes == 4);
    using Bits = std::conditional_t<bytes == 1, std::uint8_t,
                                    std::conditional_t<bytes == 2, std::uint16_t, std::uint32_t>>;
    Bits loaded = 0;
    __builtin_memcpy(&loaded, bits, bytes);
    return maskOfBits(d, loaded);
}

/// Bit k: whether lane k is set.
template <class D>
HWY_INLINE std::uint32_t bitsOfMask(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    std::uint32_t bits = 0;
    __builtin_memcpy(&bits, bytes, sizeof bits);
    return bits;
}

/// Moves the lanes of a mask to the front of vectors of 32-bit numbers. Highway's own Compress() copies its
/// table at each call where GCC compiles it for AVX2 (version 1.0.3).
template <class D>
class Packer {
public:
    HWY_INLINE Packer(D d, hn::Mask<D> mask) : Packer(mask, bitsOfMask(d, mask)) {}

    template <class V>
    HWY_INLINE V pack(V values) const {
        const hn::Vec<D> bits = hn::BitCast(D{}, values);
#if HWY_TARGET == HWY_AVX3
        return hn::BitCast(hn::DFromV<V>{}, hn::Compress(bits, mask_));
#else
        return hn::BitCast(hn::DFromV<V>{}, hn::TableLookupLanes(bits, order_));
#endif
    }

private:
#if HWY_TARGET == HWY_AVX3
    HWY_INLINE Packer(hn::Mask<D> mask, std::uint32_t) : mask_(mask) {}
    hn::Mask<D> mask_;
#else
    using Lanes32 = hn::RebindToSigned<D>;
    using Order = decltype(hn::IndicesFromVec(D{}, hn::Zero(Lanes32{})));
    HWY_INLINE Packer(hn::Mask<D>, std::uint32_t bits)
        : order_(hn::IndicesFromVec(D{}, hn::PromoteTo(Lanes32{}, hn::LoadU(hn::Rebind<std::uint8_t, D>{},
                                                                            packOrder[bits].data())))) {}
    Order order_;
#endif
};

/// One more in the lanes of the mask. T: unsigned integers.
template <class D>
HWY_INLINE hn::Vec<D> addOneIn(D d, hn::Mask<D> mask, hn::Vec<D> counts) {
#if HWY_TARGET == HWY_AVX3
    return hn::IfThenElse(mask, hn::Add(counts, hn::Set(d, 1)), counts);
#else
    return hn::Sub(counts, hn::VecFromMask(d, mask));
#endif
}

/// bits << by for unsigned 64-bit lanes, 0 where `by` is 64. The shifts of all sets do that, though Highway
/// promises it for shifts by less than 64 only.
template <class D>
HWY_INLINE hn::Vec<D> shiftLeftUpTo64(D /*d*/, hn::Vec<D> bits, hn::Vec<D> by) {
    return hn::Shl(bits, by);
}

/// The same pointer, but the compiler does not know how it was computed and makes no address from its parts.
template <class T>
HWY_INLINE T* forgetOrigin(T* pointer) {
#if HWY_COMPILER_GCC || HWY_COMPILER_CLANG
    asm("" : "+r"(pointer));
#endif
    return pointer;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
