#include "core/accumulate/horizon/uneven_block.h"

#include <algorithm>
#include <cmath>

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

constexpr int side = ReceiverBlocks::side;
constexpr Floats16 places{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

[[gnu::always_inline]] inline void raiseLine(const WallOnBlock& wall, float shift, float along,
                                             const Floats16& ground, Floats16& horizon) {
    const Floats16 low = places + (wall.low - shift), high = places + (wall.high - shift);
    const Floats16 distance = (wall.along + along) - wall.slope * low;
    const Floats16 behind = distance > 0 ? distance : Floats16{};
    Floats16 steepness;
    findSteepness(wall, low, behind, ground, steepness);
    const Ints16 shaded = (low >= 0) & (high < 0) & (distance > wall.nearest) & (steepness > horizon);
    horizon = shaded ? steepness : horizon;
}

NOONMARK_EVERY_ISA
void raiseLines(const WallOnBlock& wall, const BlockLines& lines, LineRange range, UnevenHorizons& horizons) {
    for (int line = range.first; line < range.end; ++line)
        raiseLine(wall, lines.shifts[std::size_t(line)], lines.alongs[std::size_t(line)],
                  horizons.grounds[line], horizons.lines[line]);
}

// Edges of terrain are a cell or two wide: of each line they shade as many cells. The same sums as for whole
// lines, cell by cell.
constexpr float narrowQ = 4;

void raiseCell(const WallOnBlock& wall, float low, float along, float ground, float& horizon) {
    const float distance = (wall.along + along) - wall.slope * low;
    const float over = wall.rise + wall.riseSlope * low - ground;
    if (!(distance > wall.nearest) || !(over > 0)) return;
    const float steepness = over / (over + std::max(distance, 0.0F));
    if (steepness > horizon) horizon = steepness;
}

[[maybe_unused]] void raiseCells(const WallOnBlock& wall, const BlockLines& lines, LineRange range,
                                 UnevenHorizons& horizons) {
    for (int line = range.first; line < range.end; ++line) {
        const float low = wall.low - lines.shifts[std::size_t(line)],
                    high = wall.high - lines.shifts[std::size_t(line)];
        const int first = std::max(0, int(std::ceil(-low))), end = std::min(side, int(std::ceil(-high)));
        auto* horizon = reinterpret_cast<float*>(horizons.lines + line);
        const auto* ground = reinterpret_cast<const float*>(horizons.grounds + line);
        for (int i = first; i < end; ++i)
            raiseCell(wall, float(i) + low, lines.alongs[std::size_t(line)], ground[i], horizon[i]);
    }
}

#ifdef NOONMARK_PICKS_ISA
// One cell of each line at a time.
[[gnu::target("avx512f")]] void raiseCells512(const WallOnBlock& wall, const BlockLines& lines,
                                              UnevenHorizons& horizons) {
    constexpr int up = _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC;
    constexpr __mmask16 all = 0xFFFF;
    const __m512 zero = _mm512_setzero_ps(), shifts = _mm512_loadu_ps(lines.shifts.data());
    const __m512 low = _mm512_sub_ps(_mm512_set1_ps(wall.low), shifts),
                 high = _mm512_sub_ps(_mm512_set1_ps(wall.high), shifts);
    const __m512 along = _mm512_add_ps(_mm512_set1_ps(wall.along), _mm512_loadu_ps(lines.alongs.data()));
    const __m512i nobody = _mm512_setzero_si512(), one = _mm512_set1_epi32(1);
    const __m512i end = _mm512_maskz_min_epi32(
        all, _mm512_set1_epi32(side), _mm512_maskz_cvt_roundps_epi32(all, _mm512_sub_ps(zero, high), up));
    __m512i place = _mm512_maskz_max_epi32(all, nobody,
                                           _mm512_maskz_cvt_roundps_epi32(all, _mm512_sub_ps(zero, low), up));
    const __m512i lineStarts =
        _mm512_set_epi32(240, 224, 208, 192, 176, 160, 144, 128, 112, 96, 80, 64, 48, 32, 16, 0);
    __mmask16 there = _mm512_cmplt_epi32_mask(place, end);
    for (; there != 0; place = _mm512_add_epi32(place, one), there = _mm512_cmplt_epi32_mask(place, end)) {
        const __m512i index = _mm512_add_epi32(lineStarts, place);
        const __m512 ground = _mm512_mask_i32gather_ps(zero, there, index, horizons.grounds, 4),
                     horizon = _mm512_mask_i32gather_ps(zero, there, index, horizons.lines, 4);
        const __m512 from = _mm512_add_ps(_mm512_maskz_cvtepi32_ps(all, place), low);
        const __m512 distance = _mm512_sub_ps(along, _mm512_mul_ps(_mm512_set1_ps(wall.slope), from));
        const __m512 over = _mm512_sub_ps(
            _mm512_add_ps(_mm512_set1_ps(wall.rise), _mm512_mul_ps(_mm512_set1_ps(wall.riseSlope), from)),
            ground);
        const __m512 rise = _mm512_maskz_max_ps(all, over, zero);
        const __m512 steepness =
            _mm512_div_ps(rise, _mm512_add_ps(rise, _mm512_maskz_max_ps(all, distance, zero)));
        const __mmask16 shaded =
            _mm512_mask_cmp_ps_mask(there, distance, _mm512_set1_ps(wall.nearest), _CMP_GT_OQ);
        const __mmask16 higher = _mm512_mask_cmp_ps_mask(shaded, steepness, horizon, _CMP_GT_OQ);
        _mm512_mask_i32scatter_ps(horizons.lines, higher, index, steepness, 4);
    }
}
#endif

}  // namespace

void setGrounds(const BlockGround& ground, float risePerMetre, Floats16* grounds) {
    for (int line = 0; line < ReceiverBlocks::side; ++line) {
        grounds[line] = Floats16{};
        if (ground.linesM == nullptr) continue;
        for (int i = 0; i < ReceiverBlocks::side; ++i)
            grounds[line][i] = ground.linesM[line].values[i] * risePerMetre;
    }
}

void raiseBlock(const WallOnBlock& wall, const BlockLines& lines, UnevenHorizons& horizons) {
    const bool narrow = wall.low - wall.high <= narrowQ;
    if (!narrow) return raiseLines(wall, lines, linesOf(wall, lines), horizons);
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) return raiseCells512(wall, lines, horizons);
#endif
    raiseCells(wall, lines, linesOf(wall, lines), horizons);
}

NOONMARK_EVERY_ISA
void findNeed(const Floats16* steepness, const Floats16* grounds, float lowest, BlockNeed& need) {
    const Floats16 level = Floats16{} + lowest, upright = Floats16{} + 0.9999999F;
    for (int line = 0; line < ReceiverBlocks::side; ++line) {
        const Floats16 seen = steepness[line] > level ? steepness[line] : level;
        const Floats16 below = seen < upright ? seen : upright;
        need.tans[line] = below / (1 - below);
        need.grounds[line] = seen > 1 ? Floats16{} + 1e30F : grounds[line];  // nobody's
    }
}

NOONMARK_EVERY_ISA
float leastRise(const BlockNeed& need, const BlockLines& lines, float distance) {
    constexpr float rounding = 1e-3F;
    Floats16 least = Floats16{} + 1e30F;
    for (int line = 0; line < ReceiverBlocks::side; ++line) {
        const float behind = distance + lines.alongs[std::size_t(line)];
        const float surely = behind > 0 ? behind * (1 - 1e-5F) - 1e-2F : 0;
        const Floats16 rise = need.grounds[line] + need.tans[line] * (surely > 0 ? surely : 0);
        least = rise < least ? rise : least;
    }
    float lowest = least[0];
    for (int i = 1; i < ReceiverBlocks::side; ++i) lowest = std::min(lowest, least[i]);
    return lowest - rounding;
}

}  // namespace noonmark
