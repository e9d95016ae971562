#include "core/engines/horizon/counting/run_decider.h"

#include <bit>

namespace noonmark {

void RunDecider::decide(const LongestRuns& runs, std::span<const RunLanes> horizons, std::size_t part,
                        std::uint64_t lanes, LongestRuns::Found& found, Memory& memory) const {
    doubts_.widen(horizons, memory.widened);
    const RunDoubts::Lanes inDoubt = doubts_.lanesInDoubt(runs, memory.widened, found.longest);
    std::optional<LongestRuns::Bounds> bounds;
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = std::size_t(std::countr_zero(lanes));
        const bool mayBeLonger = (inDoubt.mayBeLonger >> lane & 1) != 0,
                   mayBeShorter = (inDoubt.mayBeShorter >> lane & 1) != 0;
        if (!mayBeLonger && !mayBeShorter && !rays_.checkRuns()) continue;
        const RunSearch::Rays rays = rays_.of(blocks_.cell(part * lanesPerPart + lane));
        const bool longAsFound = !mayBeShorter && holds(runs, horizons, lane, found, rays);
        if (longAsFound && !mayBeLonger) continue;
        if (!bounds) bounds = runs.boundsOf(memory.widened.highest);
        std::int16_t& longest = found.longest.values[lane];
        memory.widened.of(lane, memory.search.horizons());
        memory.search.begin(rays, runs.steps(), longAsFound ? longest - doubts_.allowed() : 0);
        longest = std::int16_t(runs.searched(lane, *bounds, memory.search));
        rays_.countReceiver();
    }
}

// Whether the run found is hidden except for the number of steps that a run may be off. Always true if runs
// are not checked.
bool RunDecider::holds(const LongestRuns& runs, std::span<const RunLanes> horizons, std::size_t lane,
                       const LongestRuns::Found& found, const RunSearch::Rays& rays) const {
    if (!rays.findLit) return true;
    const int length = found.longest.values[lane];
    LongestRuns::Run run = runs.run(horizons, lane, found.day[lane], length);
    while (int(run.end - run.first) >= length - doubts_.allowed()) {
        const auto lit = rays.findLit(run.first, run.end);
        if (!lit) return true;
        if (*lit - run.first < run.end - *lit)
            run.first = *lit + 1;
        else
            run.end = *lit;
    }
    return false;
}

}  // namespace noonmark
