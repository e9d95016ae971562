#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd/simd_lanes.h"

namespace noonmark {

/// Vector types for registers of `bytes` bytes, which the compiler need not split on a machine with such
/// registers. `HalfInts` has as many elements as `Doubles`.
template <int bytes>
struct Registers;

template <>
struct Registers<64> {
    using Floats = Floats16;
    using Ints = Ints16;
    using Doubles = double __attribute__((vector_size(64), may_alias));
    using Longs = std::int64_t __attribute__((vector_size(64), may_alias));
    using Words = std::uint64_t __attribute__((vector_size(64), may_alias));
    using HalfInts = std::int32_t __attribute__((vector_size(32), may_alias));
};
template <>
struct Registers<32> {
    using Floats = float __attribute__((vector_size(32), may_alias));
    using Ints = std::int32_t __attribute__((vector_size(32), may_alias));
    using Doubles = double __attribute__((vector_size(32), may_alias));
    using Longs = std::int64_t __attribute__((vector_size(32), may_alias));
    using Words = std::uint64_t __attribute__((vector_size(32), may_alias));
    using HalfInts = std::int32_t __attribute__((vector_size(16), may_alias));
};
template <>
struct Registers<16> {
    using Floats = float __attribute__((vector_size(16), may_alias));
    using Ints = std::int32_t __attribute__((vector_size(16), may_alias));
    using Doubles = double __attribute__((vector_size(16), may_alias));
    using Longs = std::int64_t __attribute__((vector_size(16), may_alias));
    using Words = std::uint64_t __attribute__((vector_size(16), may_alias));
    using HalfInts = std::int32_t __attribute__((vector_size(8), may_alias));
};

template <class Register>
using FloatsOf = typename Register::Floats;
template <class Register>
using IntsOf = typename Register::Ints;
template <class Register>
using DoublesOf = typename Register::Doubles;
template <class Register>
using LongsOf = typename Register::Longs;
template <class Register>
using WordsOf = typename Register::Words;
template <class Register>
using HalfIntsOf = typename Register::HalfInts;

template <class Register>
inline constexpr std::size_t bytesIn = sizeof(FloatsOf<Register>);
/// Number of floats, or of 32-bit integers, in a register.
template <class Register>
inline constexpr int lanesIn = int(bytesIn<Register> / sizeof(float));

/// Sets the lanes to 0, 1, 2, ...
template <class Register>
[[gnu::always_inline]] inline void count(IntsOf<Register>& numbers) {
    for (int lane = 0; lane < lanesIn<Register>; ++lane) numbers[lane] = lane;
}

#ifdef NOONMARK_PICKS_ISA
template <class Kernel>
[[gnu::target("avx512f"), gnu::noinline]] void runWith64Bytes(const Kernel& kernel) {
    kernel(Registers<64>{});
}
template <class Kernel>
[[gnu::target("avx2"), gnu::noinline]] void runWith32Bytes(const Kernel& kernel) {
    kernel(Registers<32>{});
}
#endif

/// Calls kernel(Registers<bytes>{}), compiled for the widest registers that this machine has, up to
/// `mostBytes`. For kernels that neither 64-byte vectors nor loops make fast on every machine (simd_lanes.h).
/// The kernel and everything it calls must be always_inline; it should copy its captures to locals before its
/// loops.
template <int mostBytes = 64, class Kernel>
void runWithWidestRegisters(const Kernel& kernel) {
#ifdef NOONMARK_PICKS_ISA
    if constexpr (mostBytes >= 64)
        if (__builtin_cpu_supports("avx512f")) return runWith64Bytes(kernel);
    if (__builtin_cpu_supports("avx2")) return runWith32Bytes(kernel);
#endif
    kernel(Registers<16>{});
}

}  // namespace noonmark
