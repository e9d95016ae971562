#include "core/review/criteria/criterion_days.h"

#include <algorithm>

namespace noonmark {

namespace {

Measured around(double value, double error, double lowest = 0) {
    return {value, std::max(lowest, value - error), value + error};
}

std::uint32_t cellsAt(const DayShadow& day, Quantity quantity, bool former, std::size_t step) {
    const ShadedCells& cells = day.cells();
    if (quantity == Quantity::incremental) return former ? 0 : cells.incremental[step];
    const std::uint32_t shaded = former ? cells.baseline[step] : cells.scenario[step];
    return quantity == Quantity::sun ? std::uint32_t(day.shadow().baseline.receivers) - shaded : shaded;
}

/// Steps of the day for which a condition holds, as a timeline of the whole place.
struct StepCount {
    std::size_t steps = 0, runs = 0, first = 0, last = 0;
};

StepCount countSteps(const DayShadow& day, const auto& holds) {
    StepCount count;
    const auto steps = day.shadow().steps;
    bool before = false;
    for (std::size_t step = 0; step < steps.size(); ++step) {
        const bool now = holds(step);
        const bool unbroken = before && steps[step].slot == steps[step - 1].slot + 1;
        if (now && !unbroken) ++count.runs;
        if (now && count.steps == 0) count.first = step;
        if (now) count.last = step;
        count.steps += now ? 1 : 0;
        before = now;
    }
    return count;
}

StepCount countStepsWith(const DayShadow& day, Quantity quantity, bool former) {
    return countSteps(day, [&](std::size_t step) { return cellsAt(day, quantity, former, step) > 0; });
}

double spanMin(const DayShadow& day, const StepCount& count) {
    if (count.steps == 0) return 0;
    const auto steps = day.shadow().steps;
    const auto between = steps[count.last].at - steps[count.first].at;
    return double(between.count()) / 60000 + day.stepMin();
}

StepCount countFullCover(const DayShadow& day, Quantity quantity, bool former) {
    const auto all = std::uint32_t(day.shadow().baseline.receivers);
    return countSteps(day, [&](std::size_t step) {
        const bool litBefore = day.cells().baseline[step] < all;
        const bool covered = (former ? day.cells().baseline : day.cells().scenario)[step] == all;
        return covered && (quantity != Quantity::incremental || (litBefore && !former));
    });
}

std::uint32_t largestCells(const DayShadow& day, Quantity quantity, bool former) {
    std::uint32_t largest = 0;
    for (std::size_t step = 0; step < day.shadow().steps.size(); ++step)
        largest = std::max(largest, cellsAt(day, quantity, former, step));
    return largest;
}

Measured measureAreaHours(const DayShadow& day, Quantity quantity, bool former) {
    double cellSteps = 0;
    for (std::size_t step = 0; step < day.shadow().steps.size(); ++step)
        cellSteps += cellsAt(day, quantity, former, step);
    const double hours = day.stepMin() / 60 * day.shadow().cellAreaM2;
    return around(cellSteps * hours, largestCells(day, quantity, former) * hours);
}

RunCounts runsOf(const SpotRuns& runs, std::size_t cell) {
    return {runs.total[cell], runs.longest[cell], runs.longestRuns[cell], runs.count[cell]};
}

/// Minutes and runs of the worst spot: most shadow, or least sun.
Measured measureWorstSpot(const Criterion& criterion, const DayShadow& day, bool former) {
    const SpotRuns runs =
        countRuns(day.shadow(), criterion.quantity, former, {criterion.runs, criterion.dropShorterMin});
    const auto& steps = criterion.measure == Measure::spotTotal        ? runs.total
                        : criterion.measure == Measure::spotLongestRun ? runs.longest
                                                                       : runs.longestRuns;
    if (steps.empty()) return {};
    const auto worst = criterion.quantity == Quantity::sun ? std::ranges::min_element(steps)
                                                           : std::ranges::max_element(steps);
    return measureSpot(criterion, runsOf(runs, std::size_t(worst - steps.begin())),
                       {day.stepMin(), day.runErrorMin()});
}

Measured measureShare(const Criterion& criterion, const DayShadow& day, bool former) {
    const SpotRuns runs = countRuns(day.shadow(), criterion.quantity, former, {1, criterion.dropShorterMin});
    const RunError error{day.stepMin(), day.runErrorMin()};
    std::array<std::size_t, 3> meeting{};
    const std::size_t cells = runs.total.size();
    for (std::size_t cell = 0; cell < cells; ++cell)
        for (std::size_t bound = 0; bound < meeting.size(); ++bound)
            meeting[bound] += meets(criterion.spot, runsOf(runs, cell), error, int(bound) - 1) ? 1 : 0;
    if (cells == 0) return {};
    const auto share = [&](double count) { return std::clamp(count / double(cells), 0.0, 1.0); };
    // A cell on the edge of the place may be in or out; where all or no cells meet the condition it changes
    // nothing.
    const double low = meeting[0] == cells ? double(cells) : double(meeting[0]) - 1;
    const double high = meeting[2] == 0 ? 0 : double(meeting[2]) + 1;
    return {share(double(meeting[1])), share(low), share(high)};
}

Measured measureMinutes(const DayShadow& day, const StepCount& count) {
    return around(double(count.steps) * day.stepMin(), double(count.runs) * day.runErrorMin());
}

bool comparesFormer(const Criterion& criterion) {
    return std::ranges::any_of(criterion.limits, &Limit::ofFormer);
}

void addWeighted(Measured& sum, const Measured& value, double weight) {
    sum.value += weight * value.value;
    sum.low += weight * value.low;
    sum.high += weight * value.high;
}

Measured divided(const Measured& sum, double by) { return {sum.value / by, sum.low / by, sum.high / by}; }

/// Whether more of the value is worse: by the first limit, or by the quantity.
bool moreIsWorse(const Criterion& criterion) {
    if (criterion.limits.empty())
        return criterion.quantity != Quantity::sun && criterion.measure != Measure::share;
    const Comparison comparison = criterion.limits.front().comparison;
    return comparison == Comparison::atMost || comparison == Comparison::below;
}

}  // namespace

Measured measureDay(const Criterion& criterion, const DayShadow& day, bool former) {
    const Quantity quantity = criterion.quantity;
    const double cellM2 = day.shadow().cellAreaM2, cells = double(day.shadow().baseline.receivers);
    switch (criterion.measure) {
        case Measure::spotTotal:
        case Measure::spotLongestRun:
        case Measure::spotLongestRuns:
            return measureWorstSpot(criterion, day, former);
        case Measure::share:
            return measureShare(criterion, day, former);
        case Measure::anywhere:
            return measureMinutes(day, countStepsWith(day, quantity, former));
        case Measure::span: {
            const StepCount count = countStepsWith(day, quantity, former);
            return around(spanMin(day, count), count.steps > 0 ? day.runErrorMin() : 0);
        }
        case Measure::fullCover:
            return measureMinutes(day, countFullCover(day, quantity, former));
        case Measure::largestArea:
            return around(largestCells(day, quantity, former) * cellM2, cellM2);
        case Measure::largestShare:
            return cells == 0 ? Measured{} : around(largestCells(day, quantity, former) / cells, 1 / cells);
        case Measure::areaHours:
            return measureAreaHours(day, quantity, former);
        case Measure::skyComponent:  // of windows
        case Measure::probableSun:
            return {};
    }
    return {};
}

Verdict judgeLimits(const Criterion& criterion, const Measured& value, const std::optional<Measured>& former,
                    bool unchanged) {
    constexpr Measured all{1, 1, 1}, none{0, 0, 0};
    Verdict verdict = Verdict::notApplicable;
    for (const Limit& limit : criterion.limits) {
        if (limit.ofFormer && !former) continue;
        const Measured compared = limit.isLoss     ? (unchanged ? none : lossOf(value, *former))
                                  : limit.ofFormer ? (unchanged ? all : ratioOf(value, *former))
                                                   : value;
        const Verdict one = compareWith(limit.comparison, limit.value, compared);
        verdict = verdict == Verdict::notApplicable ? one : betterOf(verdict, one);
    }
    return verdict;
}

bool isInSeason(const Criterion& criterion, CivilDate date) {
    if (!criterion.season) return true;
    const std::chrono::month_day day{date.month(), date.day()};
    const auto& [first, last] = *criterion.season;
    return first <= last ? day >= first && day <= last : day >= first || day <= last;
}

bool CriterionDays::decidesMore(Verdict verdict, double value) const {
    if (!found_.value) return true;
    const bool wantsWorst = combination_ != DayCombination::chosen;
    if (verdict != found_.verdict) return (verdict > found_.verdict) == wantsWorst;
    const bool worse = moreIsWorse(*criterion_) ? value > found_.value->value : value < found_.value->value;
    return value != found_.value->value && worse == wantsWorst;
}

void CriterionDays::takeDay(CivilDate day, const Measured& value, const std::optional<Measured>& former,
                            bool unchanged) {
    const Verdict verdict = judgeLimits(*criterion_, value, former, unchanged);
    found_.failingDays += verdict == Verdict::fail ? 1 : 0;
    found_.borderlineDays += verdict == Verdict::borderline ? 1 : 0;
    if (!decidesMore(verdict, value.value)) return;
    found_.verdict = verdict;
    found_.value = value;
    found_.former = former;
    found_.day = day;
}

std::optional<double> CriterionDays::add(const DayShadow& day, double weight) {
    if (!isInSeason(*criterion_, day.shadow().day)) return std::nullopt;
    const Measured value = measureDay(*criterion_, day, false);
    std::optional<Measured> former;
    if (comparesFormer(*criterion_)) former = measureDay(*criterion_, day, true);
    add(day.shadow().day, value, former, weight);
    return value.value;
}

void CriterionDays::add(CivilDate day, const Measured& value, const std::optional<Measured>& former,
                        double weight, bool unchanged) {
    unchanged_ = unchanged_ && unchanged;
    ++found_.days;
    weights_ += weight;
    addWeighted(sum_, value, weight);
    if (former) {
        hasFormer_ = true;
        addWeighted(formerSum_, *former, weight);
    }
    if (combination_ == DayCombination::every || combination_ == DayCombination::chosen)
        takeDay(day, value, former, unchanged);
}

CriterionResult CriterionDays::result() const {
    CriterionResult result = found_;
    if (result.days == 0) result.verdict = Verdict::notApplicable;
    if (result.days == 0 || result.value) return result;
    const double by = combination_ == DayCombination::average ? weights_ : 1;
    result.value = divided(sum_, by);
    if (hasFormer_) result.former = divided(formerSum_, by);
    result.verdict = judgeLimits(*criterion_, *result.value, result.former, unchanged_);
    return result;
}

}  // namespace noonmark
