#include "core/engines/horizon/geometry/piece_bounds.h"

#include <algorithm>

#include "core/engines/horizon/geometry/block_place.h"
#include "core/simd/simd_lanes.h"

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

// Margins for distances in cells; they exceed the rounding of bounds and of the block's own coordinates.
constexpr float nearly = nearlyOfDistance, margin = 2 * roundingOfDistance;
// Depth of a block plus depth of a piece, in cells, rounded up.
constexpr float depths = 33;

[[maybe_unused]] bool mayRaiseOne(float lowQ, float highQ, float highAlong, float rise,
                                  const BlockQuery& sight) {
    const float ahead = sight.lowestAlong - highAlong, distance = ahead * nearly - margin,
                aside = std::max(0.0F, ahead + depths) * sight.spread;
    return highQ + aside > sight.lowQ && lowQ - aside < sight.highQ && rise * sight.cot > distance;
}

#ifdef NOONMARK_PICKS_ISA
[[gnu::target("avx512f")]] std::uint32_t mayRaise512(const float* lowQ, const float* highQ,
                                                     const float* highAlong, const float* rise,
                                                     const BlockQuery& sight) {
    const __m512 ahead = _mm512_sub_ps(_mm512_set1_ps(sight.lowestAlong), _mm512_loadu_ps(highAlong));
    const __m512 distance =
        _mm512_sub_ps(_mm512_mul_ps(ahead, _mm512_set1_ps(nearly)), _mm512_set1_ps(margin));
    const __m512 aside = _mm512_mul_ps(
        _mm512_maskz_max_ps(0xFFFF, _mm512_setzero_ps(), _mm512_add_ps(ahead, _mm512_set1_ps(depths))),
        _mm512_set1_ps(sight.spread));
    const __m512 seen = _mm512_mul_ps(_mm512_loadu_ps(rise), _mm512_set1_ps(sight.cot));
    __mmask16 may = _mm512_cmp_ps_mask(_mm512_add_ps(_mm512_loadu_ps(highQ), aside),
                                       _mm512_set1_ps(sight.lowQ), _CMP_GT_OQ);
    may = _mm512_mask_cmp_ps_mask(may, _mm512_sub_ps(_mm512_loadu_ps(lowQ), aside),
                                  _mm512_set1_ps(sight.highQ), _CMP_LT_OQ);
    return _mm512_mask_cmp_ps_mask(may, seen, distance, _CMP_GT_OQ);
}

[[gnu::target("avx2")]] std::uint32_t mayRaise256(const float* lowQ, const float* highQ,
                                                  const float* highAlong, const float* rise,
                                                  const BlockQuery& sight) {
    const __m256 ahead = _mm256_sub_ps(_mm256_set1_ps(sight.lowestAlong), _mm256_loadu_ps(highAlong));
    const __m256 distance =
        _mm256_sub_ps(_mm256_mul_ps(ahead, _mm256_set1_ps(nearly)), _mm256_set1_ps(margin));
    const __m256 aside =
        _mm256_mul_ps(_mm256_max_ps(_mm256_setzero_ps(), _mm256_add_ps(ahead, _mm256_set1_ps(depths))),
                      _mm256_set1_ps(sight.spread));
    const __m256 seen = _mm256_mul_ps(_mm256_loadu_ps(rise), _mm256_set1_ps(sight.cot));
    const __m256 across = _mm256_and_ps(
        _mm256_cmp_ps(_mm256_add_ps(_mm256_loadu_ps(highQ), aside), _mm256_set1_ps(sight.lowQ), _CMP_GT_OQ),
        _mm256_cmp_ps(_mm256_sub_ps(_mm256_loadu_ps(lowQ), aside), _mm256_set1_ps(sight.highQ), _CMP_LT_OQ));
    return std::uint32_t(
        _mm256_movemask_ps(_mm256_and_ps(across, _mm256_cmp_ps(seen, distance, _CMP_GT_OQ))));
}
#endif

}  // namespace

void PieceBounds::resize(std::size_t pieces) {
    for (std::vector<float>* of : {&lowQ_, &highQ_, &highAlong_, &rise_}) of->resize(pieces + together);
}

void PieceBounds::set(std::size_t piece, float lowQ, float highQ, float highAlong, float rise) {
    lowQ_[piece] = lowQ;
    highQ_[piece] = highQ;
    highAlong_[piece] = highAlong;
    rise_[piece] = rise;
}

std::uint32_t PieceBounds::mayRaise(std::size_t first, std::size_t end, const BlockQuery& sight) const {
    const std::size_t count = end - first;
    const float *lowQ = lowQ_.data() + first, *highQ = highQ_.data() + first,
                *highAlong = highAlong_.data() + first, *rise = rise_.data() + first;
#ifdef NOONMARK_PICKS_ISA
    const std::uint32_t own = count < together ? (1U << count) - 1 : 0xFFFFU;
    if (__builtin_cpu_supports("avx512f")) return own & mayRaise512(lowQ, highQ, highAlong, rise, sight);
    if (__builtin_cpu_supports("avx2"))
        return own & (mayRaise256(lowQ, highQ, highAlong, rise, sight) |
                      mayRaise256(lowQ + 8, highQ + 8, highAlong + 8, rise + 8, sight) << 8);
#endif
    std::uint32_t may = 0;
    for (std::size_t i = 0; i < together && i < count; ++i)
        may |= std::uint32_t(mayRaiseOne(lowQ[i], highQ[i], highAlong[i], rise[i], sight)) << i;
    return may;
}

}  // namespace noonmark
