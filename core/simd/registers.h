#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd/simd_lanes.h"

namespace noonmark {

/// Registers of so many bytes, as vectors that the compiler need not take apart there. `HalfInts`: as many as
/// there are doubles.
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
/// Floats, or such whole numbers, in a register.
template <class Register>
inline constexpr int lanesIn = int(bytesIn<Register> / sizeof(float));

/// 0, 1, ... in the lanes.
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

/// Calls kernel(Registers<bytes>{}) for the widest that this machine has, and no wider than asked, compiled
/// for it: for what neither vectors of 64 bytes nor loops make fast everywhere (simd_lanes.h). The kernel,
/// and all that it calls, is always_inline; it copies what it captured before its loops.
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
