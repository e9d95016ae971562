#include "core/engines/horizon/counting/sun_change.h"

#include <algorithm>
#include <bit>
#include <iterator>

#include "core/simd/simd_lanes.h"

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

/// Indices count from the lowest code up, so that they are unsigned.
struct Table {
    const std::int16_t* counts;
    int lowest, last;

    [[nodiscard]] std::int16_t of(HorizonCode horizon) const {
        return counts[std::clamp(int(horizon) - lowest, 0, last)];
    }
};

void addOneByOne(const HorizonCode* horizons, std::size_t count, const Table& table, std::int16_t* sums) {
    for (std::size_t i = 0; i < count; ++i) sums[i] = std::int16_t(sums[i] + table.of(horizons[i]));
}

#ifdef NOONMARK_PICKS_ISA
constexpr std::size_t ahead = 512;  // prefetch distance, in horizons

// Operations on 16-bit lanes need an extension that target_clones does not support. Processes 32 horizons.
[[gnu::target("avx512f,avx512bw")]] inline void lookUp512(const HorizonCode* horizons, const Table& table,
                                                          std::int16_t* sums) {
    const __m256i unsign = _mm256_set1_epi16(noHorizon),
                  lowest = _mm256_set1_epi16(short(table.lowest - noHorizon)),
                  last = _mm256_set1_epi16(short(table.last));
    for (int half = 0; half < 32; half += 16) {
        const auto* from = reinterpret_cast<const __m256i*>(horizons + half);
        auto* to = reinterpret_cast<__m256i*>(sums + half);
        const __m256i level = _mm256_xor_si256(_mm256_loadu_si256(from), unsign);
        const __m256i place = _mm256_min_epu16(_mm256_subs_epu16(level, lowest), last);
        const __m512i counts = _mm512_mask_i32gather_epi32(
            _mm512_setzero_si512(), 0xFFFF, _mm512_maskz_cvtepu16_epi32(0xFFFF, place), table.counts, 2);
        const __m256i more = _mm512_maskz_cvtepi32_epi16(0xFFFF, counts);
        _mm256_storeu_si256(to, _mm256_add_epi16(_mm256_loadu_si256(to), more));
    }
}

[[gnu::target("avx512f,avx512bw")]] std::size_t add512(const HorizonCode* horizons, std::size_t count,
                                                       const Table& table, std::int16_t* sums) {
    const __m512i unsign = _mm512_set1_epi16(noHorizon),
                  lowest = _mm512_set1_epi16(short(table.lowest - noHorizon)),
                  last = _mm512_set1_epi16(short(table.last)),
                  all = _mm512_set1_epi16(table.counts[table.last]);
    std::size_t i = 0;
    for (; i + 32 <= count; i += 32) {
        __builtin_prefetch(horizons + i + ahead);
        const __m512i level = _mm512_xor_si512(_mm512_loadu_si512(horizons + i), unsign);
        const __m512i place = _mm512_maskz_min_epu16(~0U, _mm512_subs_epu16(level, lowest), last);
        const __mmask32 some = _mm512_test_epi16_mask(place, place);
        if (some == 0) continue;
        const __m512i sum = _mm512_loadu_si512(sums + i);
        const __mmask32 whole = _mm512_cmpeq_epi16_mask(place, last);
        if (some == whole)
            _mm512_storeu_si512(sums + i, _mm512_mask_add_epi16(sum, whole, sum, all));
        else
            lookUp512(horizons + i, table, sums + i);
    }
    return i;
}

[[gnu::target("avx2")]] std::size_t add256(const HorizonCode* horizons, std::size_t count, const Table& table,
                                           std::int16_t* sums) {
    const __m256i unsign = _mm256_set1_epi16(noHorizon),
                  lowest = _mm256_set1_epi16(short(table.lowest - noHorizon)),
                  last = _mm256_set1_epi16(short(table.last)), low16 = _mm256_set1_epi32(0xFFFF);
    const auto* counts = reinterpret_cast<const int*>(table.counts);
    std::size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const auto* from = reinterpret_cast<const __m256i*>(horizons + i);
        auto* to = reinterpret_cast<__m256i*>(sums + i);
        __builtin_prefetch(horizons + i + ahead);
        const __m256i level = _mm256_xor_si256(_mm256_loadu_si256(from), unsign);
        const __m256i place = _mm256_min_epu16(_mm256_subs_epu16(level, lowest), last);
        if (_mm256_testz_si256(place, place) != 0) continue;
        const __m256i low = _mm256_cvtepu16_epi32(_mm256_castsi256_si128(place)),
                      high = _mm256_cvtepu16_epi32(_mm256_extracti128_si256(place, 1));
        const __m256i a = _mm256_and_si256(_mm256_i32gather_epi32(counts, low, 2), low16),
                      b = _mm256_and_si256(_mm256_i32gather_epi32(counts, high, 2), low16);
        const __m256i both = _mm256_permute4x64_epi64(_mm256_packus_epi32(a, b), 0b11'01'10'00);
        _mm256_storeu_si256(to, _mm256_add_epi16(_mm256_loadu_si256(to), both));
    }
    return i;
}
#endif

std::size_t addMany(const HorizonCode* horizons, std::size_t count, const Table& table, std::int16_t* sums) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512bw")) return add512(horizons, count, table, sums);
    if (__builtin_cpu_supports("avx2")) return add256(horizons, count, table, sums);
#endif
    (void)horizons, (void)count, (void)table, (void)sums;
    return 0;
}

constexpr int side = ReceiverBlocks::side;

// Returns whether a sum has changed.
bool addRow(const Table& table, const HorizonCode* before, const HorizonCode* after, unsigned mask,
            std::uint32_t* sums) {
    bool any = false;
    for (; mask != 0; mask &= mask - 1) {
        const int i = std::countr_zero(mask), more = table.of(after[i]) - table.of(before[i]);
        sums[i] += std::uint32_t(more);
        any |= more != 0;
    }
    return any;
}

#ifdef NOONMARK_PICKS_ISA
[[gnu::target("avx512f,avx512bw")]] inline void lookUpRow512(const Table& table, const HorizonCode* horizons,
                                                             __m512i& counts) {
    const __m256i codes = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(horizons));
    const __m512i level =
        _mm512_sub_epi32(_mm512_maskz_cvtepi16_epi32(0xFFFF, codes), _mm512_set1_epi32(table.lowest));
    const __m512i place = _mm512_maskz_min_epi32(
        0xFFFF, _mm512_maskz_max_epi32(0xFFFF, level, _mm512_setzero_si512()), _mm512_set1_epi32(table.last));
    const __m512i twice = _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xFFFF, place, table.counts, 2);
    // The upper half holds the count of the next index.
    counts = _mm512_maskz_srai_epi32(0xFFFF, _mm512_maskz_slli_epi32(0xFFFF, twice, 16), 16);
}

[[gnu::target("avx512f,avx512bw")]] bool addRow512(const Table& table, const HorizonCode* before,
                                                   const HorizonCode* after, unsigned mask,
                                                   std::uint32_t* sums) {
    __m512i less, more;
    lookUpRow512(table, before, less);
    lookUpRow512(table, after, more);
    const __mmask16 others = _mm512_mask_cmpneq_epi32_mask(__mmask16(mask), more, less);
    if (others == 0) return false;
    const __m512i sum = _mm512_loadu_si512(sums);
    _mm512_storeu_si512(sums, _mm512_mask_add_epi32(sum, others, sum, _mm512_sub_epi32(more, less)));
    return true;
}
#endif

std::uint16_t addDifferences(const Table& table, const HorizonCode* before, const HorizonCode* after,
                             const ReceiverBlocks::Masks& masks, std::uint32_t* sums) {
    auto add = addRow;
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512bw")) add = addRow512;
#endif
    unsigned rows = 0;
    for (std::size_t row = 0; row < masks.size(); ++row) {
        const std::size_t first = row * side;
        if (masks[row] != 0 && add(table, before + first, after + first, masks[row], sums + first))
            rows |= 1U << row;
    }
    return std::uint16_t(rows);
}

std::vector<HorizonCode> lacking(std::span<const HorizonCode> from, std::span<const HorizonCode> to) {
    std::vector<HorizonCode> missing;
    std::ranges::set_difference(from, to, std::back_inserter(missing));
    return missing;
}

std::span<const HorizonCode> some(const std::vector<HorizonCode>& suns, std::size_t turn) {
    const std::size_t first = std::min(suns.size(), turn * SunChange::mostSuns);
    return std::span(suns).subspan(first, std::min(suns.size() - first, SunChange::mostSuns));
}

}  // namespace

SunChange::SunChange(std::span<const HorizonCode> come, std::span<const HorizonCode> gone) {
    int low = steepnessLevels, high = -steepnessLevels;
    for (const auto& suns : {come, gone})
        if (!suns.empty()) {
            low = std::min(low, int(suns.front()));
            high = std::max(high, int(suns.back()));
        }
    if (low <= high) {
        lowest_ = low;
        last_ = high - low + 1;
    }
    counts_.resize(std::size_t(last_) + 2);
    fill(come, gone);
}

// Fills the counts range by range, between one sun and the next.
void SunChange::fill(std::span<const HorizonCode> come, std::span<const HorizonCode> gone) {
    std::int16_t count = 0;
    auto from = counts_.begin();
    for (auto a = come.begin(), b = gone.begin(); a != come.end() || b != gone.end();) {
        const bool comes = b == gone.end() || (a != come.end() && *a < *b);
        const auto to = counts_.begin() + ((comes ? *a++ : *b++) - lowest_ + 1);
        std::fill(from, to, count);
        from = to;
        count = std::int16_t(count + (comes ? 1 : -1));
        most_ = std::max(most_, std::abs(int(count)));
    }
    std::fill(from, counts_.end(), count);
}

std::uint16_t SunChange::addDifference(const HorizonCode* before, const HorizonCode* after,
                                       const ReceiverBlocks::Masks& masks, std::uint32_t* sums) const {
    return addDifferences({counts_.data(), lowest_, last_}, before, after, masks, sums);
}

void SunChange::addTo(const HorizonCode* horizons, std::size_t count, std::int16_t* sums) const {
    const Table table{counts_.data(), lowest_, last_};
    const std::size_t done = addMany(horizons, count, table, sums);
    addOneByOne(horizons + done, count - done, table, sums + done);
}

std::vector<SunChange> findSunChanges(std::span<const HorizonCode> suns,
                                      std::span<const HorizonCode> before) {
    const std::vector<HorizonCode> come = lacking(suns, before), gone = lacking(before, suns);
    std::vector<SunChange> changes;
    for (std::size_t turn = 0; turn * SunChange::mostSuns < std::max(come.size(), gone.size()); ++turn)
        changes.emplace_back(some(come, turn), some(gone, turn));
    return changes;
}

}  // namespace noonmark
