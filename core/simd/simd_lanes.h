#pragma once

// SIMD support shared by the kernels. simd_lanes.h has portable vectors of 64 bytes and the macro that
// compiles a function for several instruction sets; it suits kernels written as loops over lanes, which the
// compiler vectorises. registers.h calls a kernel with vectors of exactly the machine's register width, for
// kernels that need explicit comparisons and selections. All instruction sets give the same bits.

#include <cstddef>
#include <cstdint>

// Compiles a function for several instruction sets; the best one is chosen when the program starts.
// Floating-point contraction is off everywhere, so all of them give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define NOONMARK_PICKS_ISA
#define NOONMARK_EVERY_ISA __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define NOONMARK_EVERY_ISA
#endif

namespace noonmark {

/// Vectors of 64 bytes. Where registers are narrower, the compiler splits comparisons and selections of these
/// vectors into scalar operations. Code that must be fast there is therefore written as loops over lanesOf(),
/// which the compiler vectorises by itself.
using Floats16 = float __attribute__((vector_size(64), may_alias));
using Ints16 = std::int32_t __attribute__((vector_size(64), may_alias));
using Shorts32 = std::int16_t __attribute__((vector_size(64), may_alias));

/// The lanes of a vector as an array.
inline constexpr int lanesPerVector = 16;
inline const float* lanesOf(const Floats16& vector) { return reinterpret_cast<const float*>(&vector); }
inline float* lanesOf(Floats16& vector) { return reinterpret_cast<float*>(&vector); }
inline std::int32_t* lanesOf(Ints16& vector) { return reinterpret_cast<std::int32_t*>(&vector); }

/// to[lane] = from[lanes[lane]] for vectors of any length. Vectors are passed by reference, because passing
/// them by value would cross instruction sets.
template <class Ints>
[[gnu::always_inline]] inline void shuffleLanes(const Ints& from, const Ints& lanes, Ints& to) {
#ifdef __clang__
    const Ints whole = from;
    for (std::size_t i = 0; i < sizeof(Ints) / sizeof(from[0]); ++i) to[i] = whole[lanes[i]];
#else
    to = __builtin_shuffle(from, lanes);
#endif
}

/// An array that fills one cache line and is aligned to it.
template <class T>
struct alignas(64) Line {
    T values[64 / sizeof(T)] = {};
};

}  // namespace noonmark
