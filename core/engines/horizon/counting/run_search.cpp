#include "core/engines/horizon/counting/run_search.h"

#include <utility>

namespace noonmark {

void RunSearch::begin(Rays rays, std::span<const TimedStep> steps, int atLeast) {
    rays_ = std::move(rays);
    steps_ = steps;
    longest_ = std::max(0, atLeast);
    lit_.clear();
}

void RunSearch::walk(const DaySteps& day) {
    for (std::uint32_t first = day.first, end = first; first < day.end; first = end + 1) {
        for (end = first; end < day.end && mayBeHidden(end);) ++end;
        if (int(end - first) <= longest_) continue;
        first_ = first;
        states_.clear();
        for (std::uint32_t step = first; step < end; ++step) states_.push_back(firstState(step));
        search(first, end);
    }
}

// For a step that may be hidden.
RunSearch::State RunSearch::firstState(std::uint32_t step) const {
    const auto [bin, sun] = place(step);
    if (horizons_.lowest[bin] <= sun) return State::doubt;
    return rays_.findLit && isKnownLit(bin) ? State::doubt : State::hidden;
}

// No step of [first, end) is known to be lit.
void RunSearch::search(std::uint32_t first, std::uint32_t end) {
    while (int(end - first) > longest_) {
        const auto lit = litIn(first, end);
        if (!lit) {
            longest_ = int(end - first);
            return;
        }
        noteLit(*lit);
        search(first, *lit);
        first = *lit + 1;
    }
}

std::optional<std::uint32_t> RunSearch::litIn(std::uint32_t first, std::uint32_t end) {
    while (const auto step = nextDoubt(first, end)) {
        if (!rays_.hidden(*step)) return step;
        stateOf(*step) = State::hidden;
    }
    return rays_.findLit ? rays_.findLit(first, end) : std::nullopt;
}

// The step to decide next, if any.
std::optional<std::uint32_t> RunSearch::nextDoubt(std::uint32_t first, std::uint32_t end) {
    const std::uint32_t middle = first + (end - first) / 2;
    std::optional<std::uint32_t> best;
    std::uint32_t bestRank = 0;
    for (std::uint32_t step = first; step < end; ++step) {
        if (stateOf(step) != State::doubt) continue;
        const std::uint32_t fromMiddle = step < middle ? middle - step : step - middle;
        const std::uint32_t rank = (isKnownLit(place(step).bin) ? 0 : end - first) + fromMiddle;
        if (best && rank >= bestRank) continue;
        best = step;
        bestRank = rank;
    }
    return best;
}

void RunSearch::noteLit(std::uint32_t step) {
    const std::uint16_t bin = place(step).bin;
    const auto at = std::ranges::lower_bound(lit_, bin);
    if (at == lit_.end() || *at != bin) lit_.insert(at, bin);
}

}  // namespace noonmark
