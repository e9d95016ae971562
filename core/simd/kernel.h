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

// No include guard: the helpers for vectors must be defined anew for each set.
#include <hwy/highway.h>

#include "core/simd/instruction_set.h"
#include "core/simd/lanes-inl.h"

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
#endif
