#include "core/engines/projected/counting/word_runs.h"

#include <algorithm>
#include <array>

#include "core/engines/projected/counting/cell_runs.h"
#include "core/simd/simd_lanes.h"

#ifdef NOONMARK_PICKS_ISA
#include <immintrin.h>
#endif

namespace noonmark {

namespace {

using Words = std::span<const StepWords* const>;
using Starts = std::span<const RunStarts>;

// Number of steps of a group of eight that belong to the period.
std::size_t stepsOf(std::size_t eight, std::size_t steps) {
    return std::min(stepsTogether, steps - eight * stepsTogether);
}

void countAny(Words words, Starts starts, std::size_t steps, WordRuns& runs) {
    std::array<CellRuns, 64> cells{};
    std::uint64_t shaded = 0;
    for (std::size_t eight = 0; eight < words.size(); ++eight) {
        StepWords some = *words[eight];
        for (std::size_t k = stepsOf(eight, steps); k < stepsTogether; ++k) some.words[k] = 0;
        passEight(cells.data(), shaded, some.words, starts[eight], 0, std::uint32_t(eight * stepsTogether));
    }
    changeRuns(cells.data(), shaded, 0, std::uint32_t(steps));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        runs.gross[i] = cells[i].gross;
        runs.longest[i] = cells[i].longest;
    }
}

#ifdef NOONMARK_PICKS_ISA
/// 32 cells, one lane each.
struct LaneRuns {
    __m512i run, gross, longest;
};

[[gnu::target("avx512f,avx512bw"), gnu::always_inline]] inline void pass(LaneRuns& lanes,
                                                                         std::uint32_t shaded,
                                                                         const __m512i& one) {
    lanes.run = _mm512_maskz_add_epi16(shaded, lanes.run, one);
    lanes.gross = _mm512_mask_add_epi16(lanes.gross, shaded, lanes.gross, one);
    lanes.longest = _mm512_maskz_max_epu16(~0U, lanes.longest, lanes.run);
}

[[gnu::target("avx512f,avx512bw")]] void count512(Words words, Starts starts, std::size_t steps,
                                                  WordRuns& runs) {
    const __m512i none = _mm512_setzero_si512(), one = _mm512_set1_epi16(1);
    LaneRuns low{none, none, none}, high = low;
    for (std::size_t eight = 0; eight < words.size(); ++eight) {
        const std::size_t count = stepsOf(eight, steps);
        for (std::size_t k = 0; k < count; ++k) {
            if (starts[eight][k]) low.run = high.run = none;
            // Loaded directly as masks, without passing through other registers.
            const auto* shaded = reinterpret_cast<const __mmask32*>(&words[eight]->words[k]);
            pass(low, _load_mask32(const_cast<__mmask32*>(shaded)), one);
            pass(high, _load_mask32(const_cast<__mmask32*>(shaded + 1)), one);
        }
    }
    std::uint32_t *gross = runs.gross, *longest = runs.longest;
    for (const LaneRuns* lanes : {&low, &high}) {
        alignas(64) std::uint16_t counts[32];
        _mm512_store_si512(counts, lanes->gross);
        gross = std::copy(std::begin(counts), std::end(counts), gross);
        _mm512_store_si512(counts, lanes->longest);
        longest = std::copy(std::begin(counts), std::end(counts), longest);
    }
}

constexpr std::size_t mostShort = 65'535;
#endif

}  // namespace

void countRuns(Words words, Starts starts, std::size_t steps, WordRuns& runs) {
#ifdef NOONMARK_PICKS_ISA
    if (steps <= mostShort && __builtin_cpu_supports("avx512bw")) return count512(words, starts, steps, runs);
#endif
    countAny(words, starts, steps, runs);
}

}  // namespace noonmark
