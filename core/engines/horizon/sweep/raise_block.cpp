#include "core/engines/horizon/sweep/raise_block.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

[[maybe_unused]] constexpr Floats16 places{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
constexpr int side = ReceiverBlocks::side;

[[gnu::always_inline]] inline void raiseLine(const WallOnBlock& wall, float shift, float along,
                                             float* horizon) {
    const float low = wall.low - shift, high = wall.high - shift;
    const float distance = (wall.along + along) - wall.slope * low;
    const float cotAtFirst = distance * wall.perRise, less = wall.slope * wall.perRise,
                nearest = wall.nearest * wall.perRise;
    for (int i = 0; i < side; ++i) {
        const float cot = cotAtFirst - less * float(i), behind = cot > 0 ? cot : 0;
        const bool shaded = (float(i) + low >= 0) & (float(i) + high < 0) & (cot > nearest);
        horizon[i] = (shaded & (behind < horizon[i])) ? behind : horizon[i];
    }
}

NOONMARK_EVERY_ISA
void raiseLines(const WallOnBlock& wall, const BlockRows& lines, RowRange range, Floats16* horizons) {
    for (int line = range.first; line < range.end; ++line)
        raiseLine(wall, lines.shifts[std::size_t(line)], lines.alongs[std::size_t(line)],
                  lanesOf(horizons[line]));
}

NOONMARK_EVERY_ISA
void codesOfAny(const BlockHorizons& horizons, HorizonCode lowest, HorizonCode* codes) {
    const float* cots = lanesOf(horizons.lines[0]);
    for (int i = 0; i < ReceiverBlocks::cells; ++i) {
        const float cot = cots[i] > 0 ? cots[i] : 0;
        const int level = int(float(steepnessLevels) / (1 + cot));
        const int code = std::min(level, steepnessLevels - 1) + int(noHorizon);
        codes[i] = ((code > int(lowest)) & (cots[i] >= 0)) ? HorizonCode(code) : noHorizon;
    }
}

NOONMARK_EVERY_ISA
void clearAny(const ReceiverBlocks::Masks& masks, BlockHorizons& horizons) {
    constexpr float level = std::numeric_limits<float>::infinity();
    for (std::size_t line = 0; line < masks.size(); ++line) {
        const std::uint32_t receivers = masks[line];
        float* cots = lanesOf(horizons.lines[line]);
        for (unsigned i = 0; i < side; ++i)
            cots[i] = (receivers >> i & 1U) != 0 ? level : BlockHorizons::nobody;
    }
}

// Overwrites `values`.
[[gnu::always_inline]] inline float highestOf(float* values) {
    for (int half = side / 2; half > 0; half /= 2)
        for (int i = 0; i < half; ++i) values[i] = std::max(values[i], values[i + half]);
    return values[0];
}

NOONMARK_EVERY_ISA
float lowestOfAny(const BlockHorizons& horizons) {
    float lowest[side];
    std::copy_n(lanesOf(horizons.lines[0]), side, lowest);
    for (const Floats16& line : horizons.lines)
        for (int i = 0; i < side; ++i) lowest[i] = std::max(lowest[i], lanesOf(line)[i]);
    return highestOf(lowest);
}

#ifdef NOONMARK_PICKS_ISA
// Values that are constant within a row, computed for all rows at once.
struct WallBeforeLines {
    alignas(64) std::uint32_t cells[side];    // cells behind the wall, as bits
    alignas(64) float minusCotAtFirst[side];  // minus the cotangent of the horizon at the row's first cell
};

// Index of the first cell of each row whose q is not below this one: 0 to 16.
[[gnu::target("avx512f")]] inline __m512i placeFrom(__m512 q) {
    constexpr int up = _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC;
    constexpr __mmask16 all = 0xFFFF;
    const __m512i place = _mm512_maskz_cvt_roundps_epi32(all, _mm512_sub_ps(_mm512_setzero_ps(), q), up);
    return _mm512_maskz_max_epi32(all, _mm512_setzero_si512(),
                                  _mm512_maskz_min_epi32(all, _mm512_set1_epi32(side), place));
}

[[gnu::target("avx512f")]] inline void findLines(const WallOnBlock& wall, const BlockRows& lines,
                                                 WallBeforeLines& before) {
    constexpr __mmask16 all = 0xFFFF;
    const __m512 shifts = _mm512_loadu_ps(lines.shifts.data());
    const __m512 low = _mm512_sub_ps(_mm512_set1_ps(wall.low), shifts),
                 high = _mm512_sub_ps(_mm512_set1_ps(wall.high), shifts);
    const __m512i line16 = _mm512_set1_epi32(all);
    _mm512_store_si512(before.cells,
                       _mm512_maskz_andnot_epi32(all, _mm512_maskz_sllv_epi32(all, line16, placeFrom(high)),
                                                 _mm512_maskz_sllv_epi32(all, line16, placeFrom(low))));
    const __m512 along = _mm512_add_ps(_mm512_set1_ps(wall.along), _mm512_loadu_ps(lines.alongs.data()));
    const __m512 distance = _mm512_sub_ps(along, _mm512_mul_ps(_mm512_set1_ps(wall.slope), low));
    _mm512_store_ps(before.minusCotAtFirst, _mm512_mul_ps(distance, _mm512_set1_ps(-wall.perRise)));
    // Forces each row's values to be read from memory, which is free; GCC would extract them from registers
    // instead.
    asm volatile("" : "+m"(before));
}

[[gnu::target("avx512f")]] inline __mmask16 cellsOf(const WallBeforeLines& before, int line) {
    return _load_mask16(reinterpret_cast<__mmask16*>(const_cast<std::uint32_t*>(&before.cells[line])));
}

// The same operations in the same order as raiseLine(). All rows stay in registers.
[[gnu::target("avx512f")]] inline void raiseAhead512(const WallBeforeLines& before, __m512 minusLess,
                                                     __m512* horizons) {
#pragma GCC unroll 16
    for (int line = 0; line < side; ++line)
        horizons[line] =
            _mm512_mask_min_ps(horizons[line], cellsOf(before, line), horizons[line],
                               _mm512_sub_ps(minusLess, _mm512_set1_ps(before.minusCotAtFirst[line])));
}

[[gnu::target("avx512f")]] inline void raiseBeside512(const WallBeforeLines& before, __m512 minusLess,
                                                      __m512 nearest, __m512* horizons) {
    const __m512 zero = _mm512_setzero_ps();
#pragma GCC unroll 16
    for (int line = 0; line < side; ++line) {
        const __m512 cot = _mm512_sub_ps(minusLess, _mm512_set1_ps(before.minusCotAtFirst[line]));
        const __mmask16 shaded = _mm512_mask_cmp_ps_mask(cellsOf(before, line), cot, nearest, _CMP_GT_OQ);
        horizons[line] = _mm512_mask_min_ps(horizons[line], shaded, horizons[line],
                                            _mm512_maskz_max_ps(0xFFFF, cot, zero));
    }
}

[[gnu::target("avx512f")]] inline float lowestOf512(const __m512* horizons) {
    constexpr __mmask16 all = 0xFFFF;
    __m512 low[4];
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i)
        low[i] = _mm512_maskz_max_ps(all, _mm512_maskz_max_ps(all, horizons[i], horizons[i + 4]),
                                     _mm512_maskz_max_ps(all, horizons[i + 8], horizons[i + 12]));
    alignas(64) float lowest[side];
    _mm512_store_ps(lowest, _mm512_maskz_max_ps(all, _mm512_maskz_max_ps(all, low[0], low[1]),
                                                _mm512_maskz_max_ps(all, low[2], low[3])));
    return highestOf(lowest);
}

[[gnu::target("avx512f")]] float raise512(std::span<const WallOnBlock> walls, const BlockRows& lines,
                                          BlockHorizons& of) {
    const __m512 places512 = _mm512_load_ps(&places);
    __m512 horizons[side];
#pragma GCC unroll 16
    for (int line = 0; line < side; ++line) horizons[line] = _mm512_load_ps(of.lines + line);
    WallBeforeLines before;
    for (const WallOnBlock& wall : walls) {
        findLines(wall, lines, before);
        const __m512 minusLess = _mm512_mul_ps(_mm512_set1_ps(-(wall.slope * wall.perRise)), places512);
        if (wall.ahead)
            raiseAhead512(before, minusLess, horizons);
        else
            raiseBeside512(before, minusLess, _mm512_set1_ps(wall.nearest * wall.perRise), horizons);
    }
#pragma GCC unroll 16
    for (int line = 0; line < side; ++line) _mm512_store_ps(of.lines + line, horizons[line]);
    return lowestOf512(horizons);
}

[[gnu::target("avx512f")]] void clear512(const ReceiverBlocks::Masks& masks, BlockHorizons& horizons) {
    const __m512 level = _mm512_set1_ps(std::numeric_limits<float>::infinity()),
                 nobody = _mm512_set1_ps(BlockHorizons::nobody);
    for (std::size_t line = 0; line < masks.size(); ++line)
        _mm512_store_ps(horizons.lines + line, _mm512_mask_mov_ps(nobody, masks[line], level));
}

[[gnu::target("avx512f")]] void codesOf512(const BlockHorizons& horizons, HorizonCode lowest,
                                           HorizonCode* codes) {
    const __m512 levels = _mm512_set1_ps(float(steepnessLevels)), one = _mm512_set1_ps(1);
    const __m512i most = _mm512_set1_epi32(steepnessLevels - 1), none = _mm512_set1_epi32(noHorizon);
    for (std::size_t line = 0; line < std::size(horizons.lines); ++line) {
        const __m512 cot = _mm512_load_ps(horizons.lines + line);
        const __m512 scaled = _mm512_div_ps(levels, _mm512_add_ps(one, cot));
        const __m512i level = _mm512_maskz_cvttps_epi32(0xFFFF, scaled);
        const __mmask16 somebody = _mm512_cmp_ps_mask(cot, _mm512_setzero_ps(), _CMP_GE_OQ);
        const __m512i code = _mm512_add_epi32(_mm512_maskz_min_epi32(0xFFFF, level, most), none);
        const __mmask16 kept = _mm512_mask_cmpgt_epi32_mask(somebody, code, _mm512_set1_epi32(lowest));
        _mm256_store_si256(reinterpret_cast<__m256i*>(codes + line * side),
                           _mm512_maskz_cvtepi32_epi16(0xFFFF, _mm512_mask_mov_epi32(none, kept, code)));
    }
}
#endif

}  // namespace

RowRange linesOf(const WallOnBlock& wall, const BlockRows& lines) {
    if (lines.linesAQ == 0) return {0, side};
    constexpr float roundingQ = 1e-5F;  // spans many rows if shadows run almost along the rows
    const float margin = 1 + roundingQ * std::abs(lines.linesAQ);
    const float a = wall.high * lines.linesAQ, b = (wall.low + float(side - 1)) * lines.linesAQ;
    return {int(std::clamp(std::min(a, b) - margin, 0.0F, float(side))),
            int(std::clamp(std::max(a, b) + margin + 1, 0.0F, float(side)))};
}

BlockRows::BlockRows(double k, double sign) : linesAQ(k == 0 ? 0 : float(sign / k)) {
    for (int line = 0; line < side; ++line) {
        shifts[std::size_t(line)] = float(k * sign * line);
        alongs[std::size_t(line)] = float(sign * line);
    }
}

void clearBlock(const ReceiverBlocks::Masks& masks, BlockHorizons& horizons) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) return clear512(masks, horizons);
#endif
    clearAny(masks, horizons);
}

float raiseBlock(std::span<const WallOnBlock> walls, const BlockRows& lines, BlockHorizons& horizons) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) return raise512(walls, lines, horizons);
#endif
    for (const WallOnBlock& wall : walls) raiseLines(wall, lines, linesOf(wall, lines), horizons.lines);
    return lowestOfAny(horizons);
}

void toCodes(const BlockHorizons& horizons, HorizonCode lowest, HorizonCode* codes) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) return codesOf512(horizons, lowest, codes);
#endif
    codesOfAny(horizons, lowest, codes);
}

}  // namespace noonmark
