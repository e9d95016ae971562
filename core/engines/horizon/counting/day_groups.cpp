#include "core/engines/horizon/counting/day_groups.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace noonmark {

namespace {

using Visits = std::vector<SharedVisit>;

Visits visitsOf(std::span<const TimedStep> day) {
    Visits visits;
    for (const TimedStep& step : day) {
        if (visits.empty() || visits.back().bin != step.place.bin)
            visits.push_back({step.place.bin, step.place.sun, 0, true});
        visits.back().lowestSun = std::min(visits.back().lowestSun, step.place.sun);
        ++visits.back().steps;
    }
    return visits;
}

/// Extends `shared` by the visits of one more day, in that day's order.
class Merge {
public:
    explicit Merge(Visits& shared) : shared_(shared) {}

    void add(const Visits& day) {
        for (const SharedVisit& visit : day) add(visit);
    }

private:
    // A day's first visit is searched everywhere, later ones only nearby, since days differ by a few bins.
    static constexpr std::ptrdiff_t closeBy = 8;

    void add(const SharedVisit& visit) {
        const auto from = shared_.begin() + next_;
        const auto to = begun_ ? from + std::min(closeBy, shared_.end() - from) : shared_.end();
        const auto found = std::find_if(from, to, [&](const auto& other) { return other.bin == visit.bin; });
        found == to ? insert(visit) : meet(visit, found - shared_.begin());
        begun_ = true;
    }

    // Earlier days may skip this visit, so light there does not end a run unless it is the first or last
    // visit.
    void insert(SharedVisit visit) {
        visit.endsRun = next_ == 0 || next_ == std::ptrdiff_t(shared_.size());
        shared_.insert(shared_.begin() + next_, visit);
        ++next_;
    }

    // This day skips the visits in between.
    void meet(const SharedVisit& visit, std::ptrdiff_t at) {
        if (begun_)
            for (std::ptrdiff_t i = next_; i < at; ++i) shared_[std::size_t(i)].endsRun = false;
        SharedVisit& shared = shared_[std::size_t(at)];
        shared.lowestSun = std::min(shared.lowestSun, visit.lowestSun);
        shared.steps = std::max(shared.steps, visit.steps);
        next_ = at + 1;
    }

    Visits& shared_;
    std::ptrdiff_t next_ = 0;
    bool begun_ = false;
};

// The bound for the steps of a group must fit into 16 bits.
constexpr std::size_t mostStepsShared = std::numeric_limits<std::int16_t>::max();

// The sun moves around the celestial pole, in the same sense every day, so three steps determine the pole at
// any latitude. The result may be inaccurate if there are too few steps or they are too close together; it
// only decides which days are grouped.
float declinationOf(std::span<const SunStep> day) {
    const glm::dvec3 first(day.front().direction), middle(day[day.size() / 2].direction),
        last(day.back().direction);
    const glm::dvec3 pole = glm::cross(middle - first, last - first);
    const double length = glm::length(pole);
    return length > 0 ? float(glm::dot(pole, first) / length) : 0;
}

std::uint32_t endOfDay(std::span<const TimedStep> steps, std::uint32_t first) {
    std::uint32_t end = first + 1;
    while (end < steps.size() && !steps[end].startsRun) ++end;
    return end;
}

}  // namespace

std::vector<TimedStep> makeTimedSteps(const SunSteps& sun, const BinnedSun& binned) {
    std::vector<TimedStep> steps(sun.steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = {binned.places[i], i == 0 || sun.steps[i].slot != sun.steps[i - 1].slot + 1};
    for (const SunDay& day : sun.days)
        if (day.count > 0) steps[day.first].startsRun = true;
    return steps;
}

std::vector<DaySteps> sortDaysByDeclination(const SunSteps& sun, std::span<const TimedStep> steps) {
    std::vector<DaySteps> days;
    for (std::uint32_t first = 0; first < steps.size(); first = days.back().end) {
        const std::uint32_t end = endOfDay(steps, first);
        days.push_back({first, end, declinationOf(std::span(sun.steps).subspan(first, end - first))});
    }
    std::ranges::stable_sort(days, {}, &DaySteps::declination);
    return days;
}

std::vector<DayGroup> groupDays(std::span<const TimedStep> steps, std::span<const DaySteps> days,
                                const Likeness& likeness) {
    std::vector<DayGroup> groups;
    for (std::size_t first = 0, end = 0; first < days.size(); first = end) {
        DayGroup group;
        std::size_t stepsShared = 0;
        for (; end < days.size(); ++end) {
            const std::uint32_t own = days[end].end - days[end].first;
            stepsShared += own;
            const bool alike = days[end].declination - days[first].declination <= likeness.declination &&
                               end - first < likeness.mostDays && stepsShared <= mostStepsShared;
            if (end > first && !alike) break;
            group.longestDay = std::max(group.longestDay, own);
            Merge(group.visits).add(visitsOf(steps.subspan(days[end].first, own)));
        }
        group.days.assign(days.begin() + std::ptrdiff_t(first), days.begin() + std::ptrdiff_t(end));
        groups.push_back(std::move(group));
    }
    return groups;
}

}  // namespace noonmark
