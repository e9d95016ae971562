#include "core/accumulate/horizon/longest_runs.h"

#include <algorithm>
#include <numeric>

namespace noonmark {

namespace {

using Horizons = std::span<const RunLanes>;

// As good as it gets in a dense city at 41 deg north: bounds of wider groups let more days pass. Days of
// their own have bounds too, which let one in eight pass.
constexpr Likeness alike{.declination = 0.03F, .mostDays = 16}, alone{.declination = 0, .mostDays = 1};
constexpr std::uint16_t binsTogether = 3;

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

// The highest horizon of every few bins beside one another.
std::vector<RunLanes> highestOf(Horizons horizons) {
    std::vector<RunLanes> highest((horizons.size() + binsTogether - 1) / binsTogether);
    for (std::size_t i = 0; i < highest.size(); ++i) {
        const std::size_t first = i * binsTogether, end = std::min(first + binsTogether, horizons.size());
        highest[i] = horizons[first];
        for (std::size_t bin = first + 1; bin < end; ++bin)
            for (int half = 0; half < 2; ++half) {
                const Shorts32 own = halves(horizons[bin])[half], most = halves(highest[i])[half];
                halves(highest[i])[half] = own > most ? own : most;
            }
    }
    return highest;
}

}  // namespace

LongestRuns::LongestRuns(std::vector<TimedStep> steps, std::span<const DaySteps> days)
    : steps_(std::move(steps)) {
    std::vector<TimedStep> rough = steps_;
    for (TimedStep& step : rough) step.place.bin /= binsTogether;
    for (DayGroup& group : dayGroups(steps_, days, alike)) {
        std::vector<DayGroup> roughly = dayGroups(rough, group.days, alone),
                              each = dayGroups(steps_, group.days, alone);
        groups_.push_back({std::move(group), std::move(roughly), std::move(each)});
    }
}

RunLanes LongestRuns::of(std::span<const RunLanes> horizons) const {
    std::vector<RunLanes> bounds(groups_.size());
    const std::vector<RunLanes> highest = highestOf(horizons);
    std::vector<std::pair<std::int16_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < groups_.size(); ++i) {
        boundOf(horizons, groups_[i].all, bounds[i]);
        order.emplace_back(std::ranges::max(bounds[i].values), i);
    }
    std::ranges::sort(order, std::ranges::greater{});
    RunLanes longest;
    for (const auto& [most, group] : order)
        if (beats(bounds[group], longest)) walk(horizons, highest, groups_[group], longest);
    return longest;
}

void LongestRuns::walk(std::span<const RunLanes> horizons, std::span<const RunLanes> highest,
                       const Groups& groups, RunLanes& longest) const {
    const auto mayBeat = [&](std::span<const RunLanes> of, const DayGroup& day) {
        RunLanes most;
        boundOf(of, day, most);
        return beats(most, longest);
    };
    for (std::size_t i = 0; i < groups.each.size(); ++i) {
        const DaySteps& day = groups.all.days[i];
        if (mayBeat(highest, groups.roughly[i]) && mayBeat(horizons, groups.each[i]))
            walkSteps(horizons, steps().subspan(day.first, day.end - day.first), longest);
    }
}

}  // namespace noonmark
