#include "core/engines/horizon/counting/longest_runs.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace noonmark {

namespace {

using Horizons = std::span<const RunLanes>;

// The fastest choice measured in a dense city at 41 deg north. The bounds of larger groups exclude fewer
// days. Single days have rough bounds too; a bound bin by bin would cost more than to walk the day.
constexpr Likeness alike{.declination = 0.03F, .mostDays = 16}, alone{.declination = 0, .mostDays = 1};
constexpr std::uint16_t binsTogether = 4;

bool beats(const RunLanes& most, const RunLanes& longest) {
    bool any = false;
    for (std::size_t i = 0; i < lanesPerPart; ++i) any |= most.values[i] > longest.values[i];
    return any;
}

RunLanes boundOf(Horizons horizons, const DayGroup& group) {
    RunLanes most;
    boundRuns(horizons, group, most);
    return most;
}

// The highest horizon of every few neighbouring bins.
std::vector<RunLanes> highestOf(Horizons horizons) {
    std::vector<RunLanes> highest((horizons.size() + binsTogether - 1) / binsTogether);
    for (std::size_t i = 0; i < highest.size(); ++i) {
        const std::size_t first = i * binsTogether, end = std::min(first + binsTogether, horizons.size());
        highest[i] = horizons[first];
        for (std::size_t bin = first + 1; bin < end; ++bin)
            for (std::size_t lane = 0; lane < lanesPerPart; ++lane)
                highest[i].values[lane] = std::max(highest[i].values[lane], horizons[bin].values[lane]);
    }
    return highest;
}

}  // namespace

LongestRuns::LongestRuns(std::vector<TimedStep> steps, std::span<const DaySteps> days)
    : steps_(std::move(steps)) {
    std::vector<TimedStep> rough = steps_;
    for (TimedStep& step : rough) step.place.bin /= binsTogether;
    for (DayGroup& group : groupDays(steps_, days, alike)) {
        std::vector<DayGroup> single = groupDays(rough, group.days, alone);
        const auto number = std::uint32_t(days_.size());
        days_.insert(days_.end(), group.days.begin(), group.days.end());
        groups_.push_back({std::move(group), std::move(single), number});
    }
}

LongestRuns::Bounds LongestRuns::boundsOf(std::span<const RunLanes> horizons) const {
    Bounds bounds;
    std::vector<std::pair<std::int16_t, std::uint32_t>> order;
    for (std::uint32_t i = 0; i < groups_.size(); ++i) {
        bounds.ofGroup.push_back(boundOf(horizons, groups_[i].all));
        order.emplace_back(std::ranges::max(bounds.ofGroup[i].values), i);
    }
    std::ranges::sort(order, std::ranges::greater{});
    for (const auto& [most, group] : order) bounds.order.push_back(group);
    return bounds;
}

LongestRuns::Found LongestRuns::of(std::span<const RunLanes> horizons) const {
    const Bounds bounds = boundsOf(horizons);
    const std::vector<RunLanes> highest = highestOf(horizons);
    Found found;
    for (const std::uint32_t group : bounds.order)
        if (beats(bounds.ofGroup[group], found.longest)) walk(horizons, highest, groups_[group], found);
    return found;
}

LongestRuns::Run LongestRuns::run(std::span<const RunLanes> horizons, std::size_t lane, std::uint32_t day,
                                  int length) const {
    const DaySteps& steps = days_[day];
    std::uint32_t run = 0;
    for (std::uint32_t step = steps.first; step < steps.end; ++step) {
        const StepPlace& place = steps_[step].place;
        run = horizons[place.bin].values[lane] > place.sun ? run + 1 : 0;
        if (run == std::uint32_t(length)) return {step + 1 - run, step + 1};
    }
    return {};
}

std::uint64_t LongestRuns::reached(std::span<const RunLanes> horizons, const RunLanes& wanted) const {
    constexpr std::int16_t enough = std::numeric_limits<std::int16_t>::max();
    Found found;
    for (std::size_t i = 0; i < lanesPerPart; ++i)
        found.longest.values[i] = wanted.values[i] > 0 ? std::int16_t(wanted.values[i] - 1) : enough;
    const Bounds bounds = boundsOf(horizons);
    std::vector<RunLanes> highest;
    for (const std::uint32_t group : bounds.order) {
        if (!beats(bounds.ofGroup[group], found.longest)) continue;
        if (highest.empty()) highest = highestOf(horizons);
        walk(horizons, highest, groups_[group], found);
        for (std::size_t i = 0; i < lanesPerPart; ++i)
            if (found.longest.values[i] >= wanted.values[i]) found.longest.values[i] = enough;
    }
    std::uint64_t lanes = 0;
    for (std::size_t i = 0; i < lanesPerPart; ++i)
        lanes |= std::uint64_t(found.longest.values[i] == enough) << i;
    return lanes;
}

int LongestRuns::searched(std::size_t lane, const Bounds& bounds, RunSearch& search) const {
    for (const std::uint32_t group : bounds.order)
        if (bounds.ofGroup[group].values[lane] > search.longest())
            for (const DaySteps& day : groups_[group].all.days) search.walk(day);
    return search.longest();
}

void LongestRuns::walk(std::span<const RunLanes> horizons, std::span<const RunLanes> highest,
                       const Groups& groups, Found& found) const {
    for (std::size_t i = 0; i < groups.days.size(); ++i) {
        if (!beats(boundOf(highest, groups.days[i]), found.longest)) continue;
        const DaySteps& day = groups.all.days[i];
        const RunLanes before = found.longest;
        walkSteps(horizons, steps().subspan(day.first, day.end - day.first), found.longest);
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane)
            if (found.longest.values[lane] > before.values[lane])
                found.day[lane] = groups.number + std::uint32_t(i);
    }
}

}  // namespace noonmark
