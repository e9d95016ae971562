#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/projected/counting/word_runs_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <array>

#include "core/engines/projected/counting/cached_band.h"
#include "core/engines/projected/counting/shadow_events.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

constexpr std::size_t maximum = 64;
using D = LanesUpTo<std::uint16_t, maximum>;
using V = hn::Vec<D>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(d);
// The counts of this many cells stay in registers while all steps pass.
constexpr std::size_t cellsTogether = HWY_TARGET == HWY_SSE4 ? 32 : maximum, parts = cellsTogether / lanes;

/// Some cells, one lane each.
struct LaneRuns {
    V run[parts], gross[parts], longest[parts];

    HWY_INLINE LaneRuns() {
        for (std::size_t i = 0; i < parts; ++i) run[i] = gross[i] = longest[i] = hn::Zero(d);
    }
    HWY_INLINE void endRuns() {
        for (V& length : run) length = hn::Zero(d);
    }
    HWY_INLINE void pass(const std::uint64_t& shaded, std::size_t first) {
        const auto* const bits = reinterpret_cast<const std::uint8_t*>(&shaded);
        HWY_UNROLL(4)
        for (std::size_t i = 0; i < parts; ++i) {
            const auto in = loadMask(d, bits + (first + i * lanes) / 8);
            run[i] = hn::IfThenElseZero(in, hn::Add(run[i], hn::Set(d, 1)));
            gross[i] = addOneIn(d, in, gross[i]);
            longest[i] = hn::Max(longest[i], run[i]);
        }
    }
};

HWY_INLINE void write(const V* counts, std::uint32_t* to) {
    alignas(64) std::uint16_t narrow[cellsTogether];
    for (std::size_t i = 0; i < parts; ++i) hn::Store(counts[i], d, narrow + i * lanes);
    std::copy(std::begin(narrow), std::end(narrow), to);
}

}  // namespace

void countInLanes(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs) {
    for (std::size_t first = 0; first < maximum; first += cellsTogether) {
        LaneRuns cells;
        for (std::size_t eight = 0; eight < words.size(); ++eight) {
            const std::size_t count = std::min(stepsTogether, steps - eight * stepsTogether);
            const bool continues = std::ranges::count(starts[eight], true) == 0;
            for (std::size_t k = 0; k < count && continues; ++k) cells.pass(words[eight]->words[k], first);
            for (std::size_t k = 0; k < count && !continues; ++k) {
                if (starts[eight][k]) cells.endRuns();
                cells.pass(words[eight]->words[k], first);
            }
        }
        write(cells.gross, runs.gross + first);
        write(cells.longest, runs.longest + first);
    }
}

// With fewer lanes, following the changes is faster: a cell changes a few times a day.
void countWord(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs) {
    if (lanes >= 32 && steps <= maxStepsInLanes)
        countInLanes(words, starts, steps, runs);
    else
        countByChanges(words, starts, steps, runs);
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

void countByChanges(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs) {
    std::array<CellRuns, 64> cells{};
    std::uint64_t shaded = 0;
    for (std::size_t eight = 0; eight < words.size(); ++eight) {
        StepWords some = *words[eight];
        for (std::size_t k = std::min(stepsTogether, steps - eight * stepsTogether); k < stepsTogether; ++k)
            some.words[k] = 0;
        passEight(cells.data(), shaded, some.words, starts[eight], 0, std::uint32_t(eight * stepsTogether));
    }
    changeRuns(cells.data(), shaded, 0, std::uint32_t(steps));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        runs.gross[i] = cells[i].gross;
        runs.longest[i] = cells[i].longest;
    }
}

NOONMARK_KERNEL(countInLanes);
void countByLanes(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs) {
    NOONMARK_CALL(countInLanes)(words, starts, steps, runs);
}

NOONMARK_KERNEL(countWord);
void countRuns(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs) {
    NOONMARK_CALL(countWord)(words, starts, steps, runs);
}

}  // namespace noonmark
#endif
