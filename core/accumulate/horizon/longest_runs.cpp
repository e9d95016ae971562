#include "core/accumulate/horizon/longest_runs.h"

namespace noonmark {

namespace {

using Ranks = std::span<const BlockRanks>;
using Steps = std::span<const TimedStep>;

[[gnu::always_inline]] inline BlockRanks walk(const Ranks& ranks, const Steps& steps) {
    Shorts32 runA{}, runB{}, longestA{}, longestB{};
    for (const TimedStep& step : steps) {
        const auto* of = reinterpret_cast<const Shorts32*>(ranks[step.place.bin].values);
        if (step.startsRun) runA = runB = Shorts32{};
        runA = (of[0] > step.place.rank) & (runA + 1);
        runB = (of[1] > step.place.rank) & (runB + 1);
        longestA = runA > longestA ? runA : longestA;
        longestB = runB > longestB ? runB : longestB;
    }
    BlockRanks longest;
    auto* of = reinterpret_cast<Shorts32*>(longest.values);
    of[0] = longestA;
    of[1] = longestB;
    return longest;
}

#ifdef NOONMARK_PICKS_ISA
// 16-bit lanes want an extension that target_clones does not know.
[[gnu::target("avx512f,avx512bw")]] BlockRanks walk512(const Ranks& ranks, const Steps& steps) {
    return walk(ranks, steps);
}
[[gnu::target("avx2")]] BlockRanks walk256(const Ranks& ranks, const Steps& steps) {
    return walk(ranks, steps);
}
#endif

}  // namespace

BlockSums sumsOf(std::span<const BlockRanks> ranks) {
    BlockSums sums;
    for (const BlockRanks& bin : ranks)
        for (std::size_t i = 0; i < receiversABlock; ++i) sums.values[i] += bin.values[i];
    return sums;
}

BlockRanks longestRuns(std::span<const BlockRanks> ranks, std::span<const TimedStep> steps) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512bw")) return walk512(ranks, steps);
    if (__builtin_cpu_supports("avx2")) return walk256(ranks, steps);
#endif
    return walk(ranks, steps);
}

}  // namespace noonmark
