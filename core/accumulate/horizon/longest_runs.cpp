#include "core/accumulate/horizon/longest_runs.h"

#include <algorithm>
#include <numeric>

namespace noonmark {

namespace {

using Horizons = std::span<const RunLanes>;

constexpr int daysAGroup = 8, daysAPair = 2;  // a group begins where a pair begins
// A day longer than this stands alone, or the bound for several might not fit 16 bits.
constexpr std::uint32_t mostStepsShared = 32'767 / daysAGroup;

const Shorts32* halves(const RunLanes& lanes) { return reinterpret_cast<const Shorts32*>(lanes.values); }
Shorts32* halves(RunLanes& lanes) { return reinterpret_cast<Shorts32*>(lanes.values); }

[[gnu::always_inline]] inline void walk(Horizons horizons, std::span<const TimedStep> steps,
                                        RunLanes& longest) {
    const Shorts32 none{};
    Shorts32 runA{}, runB{}, longestA = halves(longest)[0], longestB = halves(longest)[1];
    for (const TimedStep& step : steps) {
        const Shorts32* of = halves(horizons[step.place.bin]);
        if (step.startsRun) runA = runB = none;
        runA = of[0] > step.place.sun ? runA + 1 : none;
        runB = of[1] > step.place.sun ? runB + 1 : none;
        longestA = runA > longestA ? runA : longestA;
        longestB = runB > longestB ? runB : longestB;
    }
    halves(longest)[0] = longestA;
    halves(longest)[1] = longestB;
}

[[gnu::always_inline]] inline void bound(Horizons horizons, const DayGroup& group, RunLanes& most) {
    const Shorts32 none{};
    Shorts32 runA{}, runB{}, mostA{}, mostB{};
    for (const SharedVisit& visit : group.visits) {
        const Shorts32* of = halves(horizons[visit.bin]);
        const Shorts32 litA = visit.endsRun ? none : runA, litB = visit.endsRun ? none : runB;
        runA = of[0] > visit.lowestSun ? runA + visit.steps : litA;
        runB = of[1] > visit.lowestSun ? runB + visit.steps : litB;
        mostA = runA > mostA ? runA : mostA;
        mostB = runB > mostB ? runB : mostB;
    }
    const Shorts32 day = none + std::int16_t(group.longestDay);
    halves(most)[0] = mostA < day ? mostA : day;
    halves(most)[1] = mostB < day ? mostB : day;
}

#ifdef NOONMARK_PICKS_ISA
// 16-bit lanes want an extension that target_clones does not know.
[[gnu::target("avx512f,avx512bw")]] void walk512(Horizons horizons, std::span<const TimedStep> steps,
                                                 RunLanes& longest) {
    walk(horizons, steps, longest);
}
[[gnu::target("avx2")]] void walk256(Horizons horizons, std::span<const TimedStep> steps, RunLanes& longest) {
    walk(horizons, steps, longest);
}
[[gnu::target("avx512f,avx512bw")]] void bound512(Horizons horizons, const DayGroup& group, RunLanes& most) {
    bound(horizons, group, most);
}
[[gnu::target("avx2")]] void bound256(Horizons horizons, const DayGroup& group, RunLanes& most) {
    bound(horizons, group, most);
}
#endif

void walkSteps(Horizons horizons, std::span<const TimedStep> steps, RunLanes& longest) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512bw")) return walk512(horizons, steps, longest);
    if (__builtin_cpu_supports("avx2")) return walk256(horizons, steps, longest);
#endif
    walk(horizons, steps, longest);
}

void boundOf(Horizons horizons, const DayGroup& group, RunLanes& most) {
#ifdef NOONMARK_PICKS_ISA
    if (__builtin_cpu_supports("avx512bw")) return bound512(horizons, group, most);
    if (__builtin_cpu_supports("avx2")) return bound256(horizons, group, most);
#endif
    bound(horizons, group, most);
}

bool beats(const RunLanes& most, const RunLanes& longest) {
    bool any = false;
    for (std::size_t i = 0; i < lanesARun; ++i) any |= most.values[i] > longest.values[i];
    return any;
}

}  // namespace

LongestRuns::LongestRuns(std::vector<TimedStep> steps) : steps_(std::move(steps)) {
    days_ = dayGroups(steps_, 1);
    const auto longDay = [](const DayGroup& day) { return day.longestDay > mostStepsShared; };
    if (std::ranges::any_of(days_, longDay)) {
        groups_ = days_;
        return;
    }
    days_ = dayGroups(steps_, daysAPair);
    groups_ = dayGroups(steps_, daysAGroup);
}

RunLanes LongestRuns::of(std::span<const RunLanes> horizons) const {
    std::vector<RunLanes> bounds(groups_.size());
    std::vector<std::pair<std::int16_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < groups_.size(); ++i) {
        boundOf(horizons, groups_[i], bounds[i]);
        order.emplace_back(std::ranges::max(bounds[i].values), i);
    }
    std::ranges::sort(order, std::ranges::greater{});
    RunLanes longest;
    for (const auto& [most, group] : order)
        if (beats(bounds[group], longest)) walkGroup(horizons, groups_[group], longest);
    return longest;
}

void LongestRuns::walkGroup(std::span<const RunLanes> horizons, const DayGroup& group,
                            RunLanes& longest) const {
    const auto from = std::ranges::lower_bound(days_, group.first, {}, &DayGroup::first);
    for (auto days = from; days != days_.end() && days->first < group.end; ++days) {
        RunLanes most;
        boundOf(horizons, *days, most);
        if (beats(most, longest))
            walkSteps(horizons, steps().subspan(days->first, days->end - days->first), longest);
    }
}

}  // namespace noonmark
