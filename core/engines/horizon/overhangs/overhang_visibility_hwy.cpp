#include "core/engines/horizon/overhangs/overhang_visibility.h"

#include <algorithm>

#include "core/simd/simd_lanes.h"

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

constexpr int side = ReceiverBlocks::side;
constexpr float onOverhangs = 1e-3F;  // in cells; a receiver closer than this is on the overhang

/// A row of a block.
struct Line16 {
    int first;  // first cell
    float shift, along;
};

[[maybe_unused]] void addCell(const StripLanes& strips, int strip, const ViewingBlock& block,
                              const Line16& line, int place, float alongPerMetre, VisibleCells& seen) {
    const int cell = line.first + place, i = seen.count;
    const float width = float(place) - (strips.low[strip] + line.shift);
    const auto &near = strips.near, &far = strips.far;
    const float ground = block.groundsM == nullptr ? 0 : block.groundsM[cell] * alongPerMetre;
    seen.cell[i] = cell;
    seen.toFar[i] = (far.distance[strip] + line.along) - far.slope[strip] * width;
    seen.toNear[i] = (near.distance[strip] + line.along) - near.slope[strip] * width;
    seen.nearRise[i] = (near.rise[strip] + near.riseSlope[strip] * width) - ground;
    seen.farRise[i] = (far.rise[strip] + far.riseSlope[strip] * width) - ground;
    seen.count += int(seen.toFar[i] > onOverhangs);
}

[[maybe_unused]] void addLine(const StripLanes& strips, const ViewingBlock& block, const Line16& line,
                              HorizonCode highest, float alongPerMetre, VisibleCells& seen) {
    int strip = 0;
    for (int place = 0; place < side; ++place) {
        while (strip < strips.count && strips.high[strip] + line.shift <= float(place)) ++strip;
        if (strip == strips.count) return;
        if (strips.low[strip] + line.shift <= float(place) &&
            block.horizons.values[line.first + place] <= highest)
            addCell(strips, strip, block, line, place, alongPerMetre, seen);
    }
}

#ifdef NOONMARK_PICKS_ISA
[[gnu::target("avx512f")]] inline __m512 pick(const float* table, __m512i strips) {
    return _mm512_maskz_permutexvar_ps(0xFFFF, strips, _mm512_load_ps(table));
}

/// Values for each cell of a row.
struct Sight512 {
    __m512i strips;
    __m512 width, along;

    [[gnu::target("avx512f")]] [[nodiscard]] __m512 distance(const StripLanes::Side& of) const {
        return _mm512_sub_ps(_mm512_add_ps(pick(of.distance, strips), along),
                             _mm512_mul_ps(pick(of.slope, strips), width));
    }
    [[gnu::target("avx512f")]] [[nodiscard]] __m512 rise(const StripLanes::Side& of, __m512 ground) const {
        return _mm512_sub_ps(
            _mm512_add_ps(pick(of.rise, strips), _mm512_mul_ps(pick(of.riseSlope, strips), width)), ground);
    }
};

// The last strip that begins at or before a cell's q.
[[gnu::target("avx512f")]] inline __m512i stripsAt(const StripLanes& strips, __m512 places, float shift) {
    __m512i at = _mm512_setzero_si512();
    for (int strip = 1; strip < strips.count; ++strip) {
        const __mmask16 from =
            _mm512_cmp_ps_mask(_mm512_set1_ps(strips.low[strip] + shift), places, _CMP_LE_OQ);
        at = _mm512_mask_add_epi32(at, from, at, _mm512_set1_epi32(1));
    }
    return at;
}

[[gnu::target("avx512f")]] inline void keep(__mmask16 some, __m512 values, float* to) {
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps(some, values));
}

[[gnu::target("avx512f")]] void addLine512(const StripLanes& strips, const ViewingBlock& block,
                                           const Line16& line, HorizonCode highest, float alongPerMetre,
                                           VisibleCells& seen) {
    const __m512i numbers = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const __m512 places = _mm512_maskz_cvtepi32_ps(0xFFFF, numbers), shift = _mm512_set1_ps(line.shift);
    const auto* codes = reinterpret_cast<const __m256i*>(block.horizons.values + line.first);
    __mmask16 some = _mm512_cmple_epi32_mask(_mm512_maskz_cvtepi16_epi32(0xFFFF, _mm256_load_si256(codes)),
                                             _mm512_set1_epi32(highest));
    if (some == 0) return;
    const __m512i at = stripsAt(strips, places, line.shift);
    const Sight512 sight{at, _mm512_sub_ps(places, _mm512_add_ps(pick(strips.low, at), shift)),
                         _mm512_set1_ps(line.along)};
    some = _mm512_mask_cmp_ps_mask(some, _mm512_add_ps(pick(strips.high, at), shift), places, _CMP_GT_OQ);
    some = _mm512_mask_cmp_ps_mask(some, _mm512_add_ps(pick(strips.low, at), shift), places, _CMP_LE_OQ);
    const __m512 toFar = sight.distance(strips.far);
    some = _mm512_mask_cmp_ps_mask(some, toFar, _mm512_set1_ps(onOverhangs), _CMP_GT_OQ);
    if (some == 0) return;
    const __m512 ground =
        block.groundsM == nullptr
            ? _mm512_setzero_ps()
            : _mm512_mul_ps(_mm512_loadu_ps(block.groundsM + line.first), _mm512_set1_ps(alongPerMetre));
    keep(some, toFar, seen.toFar + seen.count);
    keep(some, sight.distance(strips.near), seen.toNear + seen.count);
    keep(some, sight.rise(strips.near, ground), seen.nearRise + seen.count);
    keep(some, sight.rise(strips.far, ground), seen.farRise + seen.count);
    const __m512i cells = _mm512_add_epi32(numbers, _mm512_set1_epi32(line.first));
    _mm512_storeu_si512(seen.cell + seen.count, _mm512_maskz_compress_epi32(some, cells));
    seen.count += __builtin_popcount(some);
}
#endif

}  // namespace

void StripLanes::add(const OverhangStrip& strip, const BlockAxes& axes) {
    const float all = -axes.shift * float(side - 1), lowest = std::min(0.0F, all) - 1,
                highest = std::max(0.0F, all) + float(side);
    const auto from = float(strip.lowQ - axes.q), to = float(strip.highQ - axes.q);
    if (from > highest || to < lowest) return;
    low[count] = from;
    high[count] = to;
    const auto set = [&](Side& side16, const OverhangStrip::Side& of) {
        side16.distance[count] = float(axes.along - of.along);
        side16.slope[count] = float(of.slope);
        side16.rise[count] = float(of.rise);
        side16.riseSlope[count] = float(of.riseSlope);
    };
    set(near, strip.near);
    set(far, strip.far);
    ++count;
}

void addVisibleCells(const StripLanes& strips, const ViewingBlock& block, const BlockAxes& axes,
                     HorizonCode highest, VisibleCells& seen) {
    auto add = addLine;
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512f")) add = addLine512;
#endif
    for (int i = 0; i < side; ++i) {
        const Line16 line{i * side, axes.shift * float(i), axes.sign * float(i)};
        if (strips.low[0] + line.shift > float(side - 1) || strips.high[strips.count - 1] + line.shift <= 0)
            continue;
        add(strips, block, line, highest, axes.alongPerMetre, seen);
    }
}

}  // namespace noonmark
