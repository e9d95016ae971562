#include "core/engines/horizon/sweep/batch_walls.h"

#include "core/engines/horizon/geometry/block_place.h"
#include "core/simd/simd_lanes.h"

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

constexpr int most = BatchLanes::most;
constexpr float nearly = nearlyOfDistance, margin = roundingOfDistance;

// Slopes are computed in double: the narrower a wall appears, the more rounding of its ends' q affects its
// width.
[[maybe_unused]] unsigned lookAlongEach(const BatchLanes& lanes, const float* cots, const WallAhead& wall,
                                        WallInBatch& in) {
    unsigned may = 0;
    const double deep = wall.low.y - wall.high.y;
    const float distance = wall.nearestAlong * nearly - margin;
    for (int i = 0; i < most; ++i) {
        const double low = wall.low.x - lanes.k[i] * wall.low.y,
                     high = wall.high.x - lanes.k[i] * wall.high.y;
        in.low[i] = float(low);
        in.high[i] = float(high);
        in.slope[i] = float(deep / (low - high));
        in.perRise[i] = 1 / float(double(wall.topM) * lanes.alongPerMetre[i]);
        const bool across =
            (low > high) & (in.low[i] + lanes.mostOff[i] >= 0) & (in.high[i] + lanes.leastOff[i] < 0);
        const bool above = cots[i] > distance * in.perRise[i];
        may |= unsigned(across & above) << unsigned(i);
    }
    return may;
}

#ifdef NOONMARK_PICKS_ISA
/// Ends at four azimuths.
struct Ends256 {
    __m256d low, high;
};

[[gnu::target("avx2")]] inline Ends256 endsAlong(const double* k, const WallAhead& wall) {
    const __m256d k4 = _mm256_load_pd(k);
    return {_mm256_sub_pd(_mm256_set1_pd(wall.low.x), _mm256_mul_pd(k4, _mm256_set1_pd(wall.low.y))),
            _mm256_sub_pd(_mm256_set1_pd(wall.high.x), _mm256_mul_pd(k4, _mm256_set1_pd(wall.high.y)))};
}

[[gnu::target("avx2")]] inline __m256 both(__m256d a, __m256d b) {
    return _mm256_set_m128(_mm256_cvtpd_ps(b), _mm256_cvtpd_ps(a));
}

[[gnu::target("avx2")]] inline __m256 perRise256(const double* alongPerMetre, float topM) {
    const __m256d top = _mm256_set1_pd(double(topM));
    return _mm256_div_ps(_mm256_set1_ps(1), both(_mm256_mul_pd(top, _mm256_load_pd(alongPerMetre)),
                                                 _mm256_mul_pd(top, _mm256_load_pd(alongPerMetre + 4))));
}

// Returns one bit per azimuth.
[[gnu::target("avx2")]] inline unsigned facesAway(const Ends256& ends) {
    return unsigned(_mm256_movemask_pd(_mm256_cmp_pd(ends.low, ends.high, _CMP_GT_OQ)));
}

[[gnu::target("avx2")]] unsigned lookAlong256(const BatchLanes& lanes, const float* cots,
                                              const WallAhead& wall, WallInBatch& in) {
    const Ends256 a = endsAlong(lanes.k, wall), b = endsAlong(lanes.k + 4, wall);
    const __m256 low = both(a.low, b.low), high = both(a.high, b.high), zero = _mm256_setzero_ps(),
                 perRise = perRise256(lanes.alongPerMetre, wall.topM);
    const __m256 nearest = _mm256_mul_ps(_mm256_set1_ps(wall.nearestAlong * nearly - margin), perRise);
    const __m256 across =
        _mm256_and_ps(_mm256_cmp_ps(_mm256_add_ps(low, _mm256_load_ps(lanes.mostOff)), zero, _CMP_GE_OQ),
                      _mm256_cmp_ps(_mm256_add_ps(high, _mm256_load_ps(lanes.leastOff)), zero, _CMP_LT_OQ));
    const __m256 above = _mm256_cmp_ps(_mm256_load_ps(cots), nearest, _CMP_GT_OQ);
    const unsigned may =
        unsigned(_mm256_movemask_ps(_mm256_and_ps(across, above))) & (facesAway(a) | facesAway(b) << 4U);
    if (may == 0) return 0;
    const __m256d deep = _mm256_set1_pd(wall.low.y - wall.high.y);
    _mm256_store_ps(in.low, low);
    _mm256_store_ps(in.high, high);
    _mm256_store_ps(in.slope, both(_mm256_div_pd(deep, _mm256_sub_pd(a.low, a.high)),
                                   _mm256_div_pd(deep, _mm256_sub_pd(b.low, b.high))));
    _mm256_store_ps(in.perRise, perRise);
    return may;
}
#endif

}  // namespace

unsigned findRaisingAzimuths(const BatchLanes& lanes, const float* cots, const WallAhead& wall,
                             WallInBatch& in) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx2")) return lookAlong256(lanes, cots, wall, in);
#endif
    return lookAlongEach(lanes, cots, wall, in);
}

}  // namespace noonmark
