#include "core/accumulate/horizon/piece_bounds.h"

#include "core/accumulate/horizon/lanes16.h"

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

// Of distances in cells: wide of the rounding of bounds and of the block's own sums.
constexpr float nearly = 1 - 1e-5F, margin = 2e-2F;

[[maybe_unused]] bool mayRaiseOne(float lowQ, float highQ, float highAlong, float rise,
                                  const BlockSight& sight) {
    const float distance = (sight.lowestAlong - highAlong) * nearly - margin;
    return highQ > sight.lowQ && lowQ < sight.highQ && rise * sight.cot > distance;
}

#ifdef NOONMARK_PICKS_ISA
[[gnu::target("avx512f")]] std::uint32_t mayRaise512(const float* lowQ, const float* highQ,
                                                     const float* highAlong, const float* rise,
                                                     const BlockSight& sight) {
    const __m512 distance = _mm512_sub_ps(
        _mm512_mul_ps(_mm512_sub_ps(_mm512_set1_ps(sight.lowestAlong), _mm512_loadu_ps(highAlong)),
                      _mm512_set1_ps(nearly)),
        _mm512_set1_ps(margin));
    const __m512 seen = _mm512_mul_ps(_mm512_loadu_ps(rise), _mm512_set1_ps(sight.cot));
    __mmask16 may = _mm512_cmp_ps_mask(_mm512_loadu_ps(highQ), _mm512_set1_ps(sight.lowQ), _CMP_GT_OQ);
    may = _mm512_mask_cmp_ps_mask(may, _mm512_loadu_ps(lowQ), _mm512_set1_ps(sight.highQ), _CMP_LT_OQ);
    return _mm512_mask_cmp_ps_mask(may, seen, distance, _CMP_GT_OQ);
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

std::uint32_t PieceBounds::mayRaise(std::size_t first, std::size_t end, const BlockSight& sight) const {
    const std::size_t count = end - first;
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) {
        const std::uint32_t own = count < together ? (1U << count) - 1 : 0xFFFFU;
        return own & mayRaise512(lowQ_.data() + first, highQ_.data() + first, highAlong_.data() + first,
                                 rise_.data() + first, sight);
    }
#endif
    std::uint32_t may = 0;
    for (std::size_t i = 0; i < together && i < count; ++i)
        may |= std::uint32_t(mayRaiseOne(lowQ_[first + i], highQ_[first + i], highAlong_[first + i],
                                         rise_[first + i], sight))
               << i;
    return may;
}

}  // namespace noonmark
