#include "core/accumulate/horizon/day_groups.h"

#include <algorithm>

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

/// Makes `shared` hold the visits of one more day, in that day's order.
class Merge {
public:
    explicit Merge(Visits& shared) : shared_(shared) {}

    void add(const Visits& day) {
        for (const SharedVisit& visit : day) add(visit);
    }

private:
    // A day's first visit is looked for everywhere, others close by: days differ by a few bins.
    static constexpr std::ptrdiff_t closeBy = 8;

    void add(const SharedVisit& visit) {
        const auto from = shared_.begin() + next_;
        const auto to = begun_ ? from + std::min(closeBy, shared_.end() - from) : shared_.end();
        const auto found = std::find_if(from, to, [&](const auto& other) { return other.bin == visit.bin; });
        found == to ? insert(visit) : meet(visit, found - shared_.begin());
        begun_ = true;
    }

    // Days on both sides may pass over it.
    void insert(SharedVisit visit) {
        visit.endsRun = next_ == 0 || next_ == std::ptrdiff_t(shared_.size());
        shared_.insert(shared_.begin() + next_, visit);
        ++next_;
    }

    // This day passes over what lies between.
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

std::uint32_t endOfDay(std::span<const TimedStep> steps, std::uint32_t first) {
    std::uint32_t end = first + 1;
    while (end < steps.size() && !steps[end].startsRun) ++end;
    return end;
}

}  // namespace

std::vector<TimedStep> timedSteps(const SunSteps& sun, const BinnedSun& binned) {
    std::vector<TimedStep> steps(sun.steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = {binned.places[i], i == 0 || sun.steps[i].slot != sun.steps[i - 1].slot + 1};
    for (const SunDay& day : sun.days)
        if (day.count > 0) steps[day.first].startsRun = true;
    return steps;
}

std::vector<DayGroup> dayGroups(std::span<const TimedStep> steps, int daysAGroup) {
    std::vector<DayGroup> groups;
    int days = daysAGroup;
    for (std::uint32_t first = 0; first < steps.size();) {
        const std::uint32_t end = endOfDay(steps, first);
        if (days++ >= daysAGroup) {
            groups.push_back({first, first, 0, {}});
            days = 1;
        }
        groups.back().end = end;
        groups.back().longestDay = std::max(groups.back().longestDay, end - first);
        Merge(groups.back().visits).add(visitsOf(steps.subspan(first, end - first)));
        first = end;
    }
    return groups;
}

}  // namespace noonmark
