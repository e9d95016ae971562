#pragma once

#include <cstddef>
#include <cstdint>

// A function marked so is compiled for several instruction sets and the best one is picked when the program
// starts. Contraction is off everywhere, so all give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define NOONMARK_PICKS_ISA
#define NOONMARK_EVERY_ISA __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define NOONMARK_EVERY_ISA
#endif

namespace noonmark {

/// 64 bytes at a time. Where registers are shorter the compiler takes comparisons and choices apart number by
/// number, so what must be fast there too is written as loops over lanesOf(), which it puts together by
/// itself.
using Floats16 = float __attribute__((vector_size(64), may_alias));
using Ints16 = std::int32_t __attribute__((vector_size(64), may_alias));
using Shorts32 = std::int16_t __attribute__((vector_size(64), may_alias));

/// The numbers of such a vector, one by one.
inline constexpr int lanesPerVector = 16;
inline const float* lanesOf(const Floats16& vector) { return reinterpret_cast<const float*>(&vector); }
inline float* lanesOf(Floats16& vector) { return reinterpret_cast<float*>(&vector); }
inline std::int32_t* lanesOf(Ints16& vector) { return reinterpret_cast<std::int32_t*>(&vector); }

/// to[lane] = from[lanes[lane]] in such vectors of any length. Vectors go by reference: as values they would
/// cross instruction sets.
template <class Ints>
[[gnu::always_inline]] inline void shuffleLanes(const Ints& from, const Ints& lanes, Ints& to) {
#ifdef __clang__
    const Ints whole = from;
    for (std::size_t i = 0; i < sizeof(Ints) / sizeof(from[0]); ++i) to[i] = whole[lanes[i]];
#else
    to = __builtin_shuffle(from, lanes);
#endif
}

/// Memory that starts on a cache line.
template <class T>
struct alignas(64) Line {
    T values[64 / sizeof(T)] = {};
};

}  // namespace noonmark
