#include "core/engines/horizon/sweep/uneven_block.h"

#include <algorithm>
#include <cmath>

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

constexpr int side = ReceiverBlocks::side;
[[gnu::always_inline]] inline void raiseLine(const WallOnBlock& wall, float shift, float along,
                                             const float* ground, float* horizon) {
    EdgeHorizon edge;
    findHorizon(wall, shift, along, ground, edge);
    for (int i = 0; i < side; ++i)
        horizon[i] = ((edge.shaded[i] != 0) & (edge.cot[i] < horizon[i])) ? edge.cot[i] : horizon[i];
}

NOONMARK_EVERY_ISA
void raiseLines(const WallOnBlock& wall, const BlockRows& lines, RowRange range, UnevenHorizons& horizons) {
    for (int line = range.first; line < range.end; ++line)
        raiseLine(wall, lines.shifts[std::size_t(line)], lines.alongs[std::size_t(line)],
                  lanesOf(horizons.grounds[line]), lanesOf(horizons.lines[line]));
}

// Edges of terrain are one or two cells wide and affect as many cells of each row. These cells are processed
// singly, with the same operations as whole rows.
constexpr float narrowQ = 4;

void raiseCell(const WallOnBlock& wall, float place, float low, float distance, float ground,
               float& horizon) {
    const float over = wall.rise + wall.riseSlope * (place + low) - ground;
    if (!(over > 0)) return;
    const float perRise = 1 / over, cot = distance * perRise - wall.slope * perRise * place;
    if (cot > wall.nearest * perRise) horizon = std::min(horizon, std::max(cot, 0.0F));
}

[[maybe_unused]] void raiseCells(const WallOnBlock& wall, const BlockRows& lines, RowRange range,
                                 UnevenHorizons& horizons) {
    for (int line = range.first; line < range.end; ++line) {
        const float low = wall.low - lines.shifts[std::size_t(line)],
                    high = wall.high - lines.shifts[std::size_t(line)];
        const float distance = (wall.along + lines.alongs[std::size_t(line)]) - wall.slope * low;
        const int first = std::max(0, int(std::ceil(-low))), end = std::min(side, int(std::ceil(-high)));
        auto* horizon = reinterpret_cast<float*>(horizons.lines + line);
        const auto* ground = reinterpret_cast<const float*>(horizons.grounds + line);
        for (int i = first; i < end; ++i) raiseCell(wall, float(i), low, distance, ground[i], horizon[i]);
    }
}

#ifdef NOONMARK_PICKS_ISA
// Processes one cell of every row at a time.
[[gnu::target("avx512f")]] void raiseCells512(const WallOnBlock& wall, const BlockRows& lines,
                                              UnevenHorizons& horizons) {
    constexpr int up = _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC;
    constexpr __mmask16 all = 0xFFFF;
    const __m512 zero = _mm512_setzero_ps(), shifts = _mm512_loadu_ps(lines.shifts.data());
    const __m512 low = _mm512_sub_ps(_mm512_set1_ps(wall.low), shifts),
                 high = _mm512_sub_ps(_mm512_set1_ps(wall.high), shifts);
    const __m512 along = _mm512_add_ps(_mm512_set1_ps(wall.along), _mm512_loadu_ps(lines.alongs.data()));
    const __m512 slope = _mm512_set1_ps(wall.slope);
    const __m512 distance = _mm512_sub_ps(along, _mm512_mul_ps(slope, low));
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
        const __m512 at = _mm512_maskz_cvtepi32_ps(all, place);
        const __m512 over = _mm512_sub_ps(
            _mm512_add_ps(_mm512_set1_ps(wall.rise),
                          _mm512_mul_ps(_mm512_set1_ps(wall.riseSlope), _mm512_add_ps(at, low))),
            ground);
        const __m512 perRise = _mm512_div_ps(_mm512_set1_ps(1), _mm512_maskz_max_ps(all, over, zero));
        const __m512 signedCot =
            _mm512_sub_ps(_mm512_mul_ps(distance, perRise), _mm512_mul_ps(_mm512_mul_ps(slope, perRise), at));
        const __mmask16 shaded = _mm512_mask_cmp_ps_mask(
            there, signedCot, _mm512_mul_ps(_mm512_set1_ps(wall.nearest), perRise), _CMP_GT_OQ);
        const __m512 cot = _mm512_maskz_max_ps(all, signedCot, zero);
        const __mmask16 higher = _mm512_mask_cmp_ps_mask(shaded, cot, horizon, _CMP_LT_OQ);
        _mm512_mask_i32scatter_ps(horizons.lines, higher, index, cot, 4);
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

void raiseBlock(const WallOnBlock& wall, const BlockRows& lines, UnevenHorizons& horizons) {
    const bool narrow = wall.low - wall.high <= narrowQ;
    if (!narrow) return raiseLines(wall, lines, linesOf(wall, lines), horizons);
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) return raiseCells512(wall, lines, horizons);
#endif
    raiseCells(wall, lines, linesOf(wall, lines), horizons);
}

NOONMARK_EVERY_ISA
void findNeed(const Floats16* cots, const Floats16* grounds, float lowest, BlockNeed& need) {
    constexpr float upright = 1e-7F;
    for (int line = 0; line < side; ++line)
        for (int i = 0; i < side; ++i) {
            const float seen = std::min(lanesOf(cots[line])[i], lowest);
            lanesOf(need.tans[line])[i] = 1 / std::max(seen, upright);
            lanesOf(need.grounds[line])[i] = seen < 0 ? 1e30F : lanesOf(grounds[line])[i];  // not a receiver
        }
}

NOONMARK_EVERY_ISA
float findLeastRise(const BlockNeed& need, const BlockRows& lines, float distance) {
    constexpr float rounding = 1e-3F;
    float least[side];
    std::fill_n(least, side, 1e30F);
    for (int line = 0; line < side; ++line) {
        const float behind = distance + lines.alongs[std::size_t(line)];
        const float surely = behind > 0 ? std::max(0.0F, behind * (1 - 1e-5F) - 1e-2F) : 0;
        for (int i = 0; i < side; ++i)
            least[i] =
                std::min(least[i], lanesOf(need.grounds[line])[i] + lanesOf(need.tans[line])[i] * surely);
    }
    const float lowest = *std::min_element(least, least + side);
    return lowest - rounding;
}

}  // namespace noonmark
