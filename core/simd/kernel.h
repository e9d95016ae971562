// For source files that hold kernels, whose names end in _hwy.cpp. Such a file is compiled once for each
// instruction set (Highway's foreach_target.h), each time into a namespace of its own:
//
//     #undef HWY_TARGET_INCLUDE
//     #define HWY_TARGET_INCLUDE ".../sum_hwy.cpp"  // this file
//     #include <hwy/foreach_target.h>
//
//     #include ".../sum.h"
//     #include "core/simd/kernel.h"
//
//     HWY_BEFORE_NAMESPACE();
//     namespace noonmark::HWY_NAMESPACE {
//     float sum(const float* values, std::size_t count) { ... }  // the kernel, with vectors of any width
//     }  // namespace noonmark::HWY_NAMESPACE
//     HWY_AFTER_NAMESPACE();
//
//     #if HWY_ONCE
//     namespace noonmark {
//     NOONMARK_KERNEL(sum);
//     float sum(const float* values, std::size_t count) { return NOONMARK_CALL(sum)(values, count); }
//     }  // namespace noonmark
//     #endif
//
// Kernels may use no fused multiply-add (MulAdd) and no approximations, so that all sets give the same bits.
// Highway leaves open what Min and Max return for NaN; kernels compare and select where there may be one.

// No include guard: the helpers for vectors at the end must be defined anew for each set.
#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/simd/instruction_set.h"

#ifndef NOONMARK_KERNEL
#if HWY_ARCH_X86
/// Defines the table of a kernel's functions, in the order of builtSets (instruction_set_hwy.cpp).
#define NOONMARK_KERNEL(function)                                           \
    constexpr decltype(&N_SSE4::function) HWY_CONCAT(function, OnSet)[] = { \
        &N_SSE4::function, &N_AVX2::function, &N_AVX3::function}
#else
#define NOONMARK_KERNEL(function) \
    constexpr decltype(&N_NEON::function) HWY_CONCAT(function, OnSet)[] = {&N_NEON::function}
#endif
/// The kernel's function for the instruction set in use.
#define NOONMARK_CALL(function) \
    (HWY_CONCAT(function, OnSet)[noonmark::simd::tableIndex.load(std::memory_order_relaxed)])

namespace noonmark {

/// What Packer looks up: for each set of eight lanes, as bits: its lanes in ascending order, then the others.
/// The first four entries of the first sixteen are the same for four lanes.
inline constexpr auto packOrder = [] {
    std::array<std::array<std::uint8_t, 8>, 256> order{};
    for (unsigned set = 0; set < order.size(); ++set) {
        std::size_t next = 0;
        for (const unsigned wanted : {1U, 0U})
            for (unsigned lane = 0; lane < 8; ++lane)
                if ((set >> lane & 1U) == wanted) order[set][next++] = std::uint8_t(lane);
    }
    return order;
}();

}  // namespace noonmark
#endif

// The helpers for vectors, once for each instruction set.
#if defined(NOONMARK_SIMD_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef NOONMARK_SIMD_LANES
#undef NOONMARK_SIMD_LANES
#else
#define NOONMARK_SIMD_LANES
#endif

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
