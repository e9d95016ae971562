#include "core/accumulate/horizon/raise_block.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

constexpr Ints16 counting{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr Floats16 places{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr int side = ReceiverBlocks::side;

[[gnu::always_inline]] inline void raiseLine(const WallOnBlock& wall, float shift, float along,
                                             Floats16& horizon) {
    const Floats16 low = places + (wall.low - shift), high = places + (wall.high - shift);
    const Floats16 distance = (wall.along + along) - wall.slope * low;
    const Floats16 behind = distance > 0 ? distance : Floats16{};
    const Floats16 steepness = wall.rise / (wall.rise + behind);
    const Ints16 shaded = (low >= 0) & (high < 0) & (distance > wall.nearest) & (steepness > horizon);
    horizon = shaded ? steepness : horizon;
}

NOONMARK_EVERY_ISA
void raiseLines(const WallOnBlock& wall, const BlockLines& lines, LineRange range, Floats16* horizons) {
    for (int line = range.first; line < range.end; ++line)
        raiseLine(wall, lines.shifts[std::size_t(line)], lines.alongs[std::size_t(line)], horizons[line]);
}

NOONMARK_EVERY_ISA
void codesOfAny(const BlockHorizons& horizons, HorizonCode lowest, HorizonCode* codes) {
    using Shorts16 = std::int16_t __attribute__((vector_size(32), may_alias));
    for (std::size_t line = 0; line < std::size(horizons.lines); ++line) {
        const Ints16 level = __builtin_convertvector(horizons.lines[line] * float(steepnessLevels), Ints16);
        const Ints16 most = Ints16{} + (steepnessLevels - 1);
        const Ints16 code = (level < most ? level : most) + int(noHorizon);
        const Ints16 kept =
            (code > int(lowest)) & (level <= steepnessLevels) ? code : Ints16{} + int(noHorizon);
        *reinterpret_cast<Shorts16*>(codes + line * side) = __builtin_convertvector(kept, Shorts16);
    }
}

#ifdef NOONMARK_PICKS_ISA
// The same sums in the same order; comparisons go to masks, which the compiler does not do by itself.
[[gnu::target("avx512f")]] void raiseLines512(const WallOnBlock& wall, const BlockLines& lines,
                                              LineRange range, Floats16* horizons) {
    const __m512 place = _mm512_load_ps(&places), zero = _mm512_setzero_ps();
    const __m512 slope = _mm512_set1_ps(wall.slope), rise = _mm512_set1_ps(wall.rise),
                 nearest = _mm512_set1_ps(wall.nearest);
    for (int line = range.first; line < range.end; ++line) {
        const float shift = lines.shifts[std::size_t(line)];
        const __m512 low = _mm512_add_ps(place, _mm512_set1_ps(wall.low - shift));
        const __m512 high = _mm512_add_ps(place, _mm512_set1_ps(wall.high - shift));
        const __mmask16 within =
            _mm512_mask_cmp_ps_mask(_mm512_cmp_ps_mask(low, zero, _CMP_GE_OQ), high, zero, _CMP_LT_OQ);
        const __m512 distance = _mm512_sub_ps(_mm512_set1_ps(wall.along + lines.alongs[std::size_t(line)]),
                                              _mm512_mul_ps(slope, low));
        const __m512 behind = _mm512_maskz_max_ps(0xFFFF, distance, zero);
        const __m512 steepness = _mm512_div_ps(rise, _mm512_add_ps(rise, behind));
        const __mmask16 shaded = _mm512_mask_cmp_ps_mask(within, distance, nearest, _CMP_GT_OQ);
        const __m512 horizon = _mm512_load_ps(horizons + line);
        const __mmask16 higher = _mm512_mask_cmp_ps_mask(shaded, steepness, horizon, _CMP_GT_OQ);
        _mm512_store_ps(horizons + line, _mm512_mask_mov_ps(horizon, higher, steepness));
    }
}

[[gnu::target("avx512f")]] void codesOf512(const BlockHorizons& horizons, HorizonCode lowest,
                                           HorizonCode* codes) {
    const __m512 levels = _mm512_set1_ps(float(steepnessLevels));
    const __m512i most = _mm512_set1_epi32(steepnessLevels - 1), none = _mm512_set1_epi32(noHorizon);
    for (std::size_t line = 0; line < std::size(horizons.lines); ++line) {
        const __m512 scaled = _mm512_mul_ps(_mm512_load_ps(horizons.lines + line), levels);
        const __m512i level = _mm512_maskz_cvttps_epi32(0xFFFF, scaled);
        const __mmask16 somebody = _mm512_cmple_epi32_mask(level, _mm512_set1_epi32(steepnessLevels));
        const __m512i code = _mm512_add_epi32(_mm512_maskz_min_epi32(0xFFFF, level, most), none);
        const __mmask16 kept = _mm512_mask_cmpgt_epi32_mask(somebody, code, _mm512_set1_epi32(lowest));
        _mm256_store_si256(reinterpret_cast<__m256i*>(codes + line * side),
                           _mm512_maskz_cvtepi32_epi16(0xFFFF, _mm512_mask_mov_epi32(none, kept, code)));
    }
}
#endif

}  // namespace

LineRange linesOf(const WallOnBlock& wall, const BlockLines& lines) {
    if (lines.linesAQ == 0) return {0, side};
    constexpr float roundingQ = 1e-5F;  // many lines, where the shadows run nearly along them
    const float margin = 1 + roundingQ * std::abs(lines.linesAQ);
    const float a = wall.high * lines.linesAQ, b = (wall.low + float(side - 1)) * lines.linesAQ;
    return {int(std::clamp(std::min(a, b) - margin, 0.0F, float(side))),
            int(std::clamp(std::max(a, b) + margin + 1, 0.0F, float(side)))};
}

BlockLines::BlockLines(double k, double sign) : linesAQ(k == 0 ? 0 : float(sign / k)) {
    for (int line = 0; line < side; ++line) {
        shifts[std::size_t(line)] = float(k * sign * line);
        alongs[std::size_t(line)] = float(sign * line);
    }
}

NOONMARK_EVERY_ISA
void clearBlock(const ReceiverBlocks::Masks& masks, BlockHorizons& horizons) {
    const Floats16 level{}, nobody = level + BlockHorizons::nobody;
    for (std::size_t line = 0; line < masks.size(); ++line) {
        const Ints16 receiver = ((Ints16{} + masks[line]) >> counting) & 1;
        horizons.lines[line] = receiver != 0 ? level : nobody;
    }
}

void raiseBlock(const WallOnBlock& wall, const BlockLines& lines, BlockHorizons& horizons) {
    const LineRange range = linesOf(wall, lines);
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) return raiseLines512(wall, lines, range, horizons.lines);
#endif
    raiseLines(wall, lines, range, horizons.lines);
}

NOONMARK_EVERY_ISA
float lowestOf(const BlockHorizons& horizons) {
    Floats16 low = horizons.lines[0];
    for (const Floats16& line : horizons.lines) low = line < low ? line : low;
    float lowest = low[0];
    for (int i = 1; i < side; ++i) lowest = std::min(lowest, low[i]);
    return lowest;
}

void codesOf(const BlockHorizons& horizons, HorizonCode lowest, HorizonCode* codes) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) return codesOf512(horizons, lowest, codes);
#endif
    codesOfAny(horizons, lowest, codes);
}

}  // namespace noonmark
