#include "core/review/criteria/criterion_days.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/measures/places/place_sums.h"
#include "core/review/criteria/worst_spots.h"

namespace noonmark {

namespace {

Measured around(double value, double error, double lowest = 0) {
    return {value, std::max(lowest, value - error), value + error};
}

std::uint32_t cellsAt(const DayShadow& day, Quantity quantity, bool former, std::size_t step) {
    const ShadedCells& cells = day.cells();
    if (quantity == Quantity::incremental) return former ? 0 : cells.incremental[step];
    const std::uint32_t shaded = former ? cells.baseline[step] : cells.scenario[step];
    return quantity == Quantity::sun ? std::uint32_t(day.centres()) - shaded : shaded;
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
    const auto all = std::uint32_t(day.centres());
    return countSteps(day, [&](std::size_t step) {
        const bool litBefore = day.cells().baseline[step] < all;
        const bool covered = (former ? day.cells().baseline : day.cells().scenario)[step] == all;
        return covered && (quantity != Quantity::incremental || (litBefore && !former));
    });
}

double areaAt(const DayShadow& day, Quantity quantity, bool former, std::size_t step) {
    const ShadedCells& cells = day.cells();
    if (quantity == Quantity::incremental) return former ? 0 : cells.incrementalM2[step];
    const double shaded = former ? cells.baselineM2[step] : cells.scenarioM2[step];
    return quantity == Quantity::sun ? std::max(0.0, day.areaM2() - shaded) : shaded;
}

std::size_t edgesAt(const DayShadow& day, Quantity quantity, bool former, std::size_t step) {
    const PlaceShadow& shadow = day.shadow();
    const auto before = shadow.baseline.at(step), after = shadow.scenario.at(step);
    if (quantity != Quantity::incremental) return countEdges(former ? before : after, shadow.neighbours);
    std::vector<std::uint64_t> added(after.begin(), after.end());
    for (std::size_t word = 0; word < added.size(); ++word) added[word] &= ~before[word];
    return countEdges(added, shadow.neighbours);
}

/// Half of the cells that an edge passes through, at least one.
double edgeErrorCells(std::size_t edges) { return std::max(1.0, double(edges) / 2); }

/// How far the cells may miss an area: nothing, or the whole place, has no edge.
double areaErrorM2(const DayShadow& day, Quantity quantity, bool former, std::size_t step) {
    const double areaM2 = areaAt(day, quantity, former, step);
    constexpr double roundingM2 = 1e-6;
    if (areaM2 <= 0 || areaM2 >= day.areaM2() - roundingM2) return 0;
    return std::min(areaM2, edgeErrorCells(edgesAt(day, quantity, former, step)) * day.shadow().cellAreaM2);
}

Measured measureLargestArea(const DayShadow& day, Quantity quantity, bool former) {
    double largest = 0;
    std::size_t at = 0;
    for (std::size_t step = 0; step < day.shadow().steps.size(); ++step)
        if (const double areaM2 = areaAt(day, quantity, former, step); areaM2 > largest)
            largest = areaM2, at = step;
    return largest > 0 ? around(largest, areaErrorM2(day, quantity, former, at)) : Measured{};
}

Measured measureLargestShare(const DayShadow& day, Quantity quantity, bool former) {
    if (day.areaM2() <= 0) return {};
    const Measured area = measureLargestArea(day, quantity, former);
    const auto shareOf = [&](double areaM2) { return std::min(1.0, areaM2 / day.areaM2()); };
    return {shareOf(area.value), shareOf(area.low), shareOf(area.high)};
}

/// What the steps may miss of an area x hours, in m2 x steps: between two steps the area lies between theirs.
double timeErrorSteps(const std::vector<double>& areas) {
    if (areas.size() < 2) return areas.empty() ? 0 : areas.front();
    double changes = 0;
    for (std::size_t step = 1; step < areas.size(); ++step)
        changes += std::abs(areas[step] - areas[step - 1]);
    const double last = std::abs(areas.back() - areas[areas.size() - 2]);
    return (changes + std::abs(areas.back() - areas.front()) + last) / 2;
}

Measured measureAreaHours(const DayShadow& day, Quantity quantity, bool former) {
    std::vector<double> areas;
    double sum = 0, error = 0;
    for (std::size_t step = 0; step < day.shadow().steps.size(); ++step) {
        areas.push_back(areaAt(day, quantity, former, step));
        sum += areas.back();
        error += areaErrorM2(day, quantity, former, step);
    }
    const double hours = day.stepMin() / 60;
    return around(sum * hours, (error + timeErrorSteps(areas)) * hours);
}

RunCounts runsOf(const SpotRuns& runs, std::size_t cell) {
    return {runs.total[cell], runs.longest[cell], runs.longestRuns[cell], runs.count[cell]};
}

struct WorstSpot {
    std::uint32_t steps = 0;
    RunCounts runs;
};

/// Takes the worst of these spots, most shadow or least sun, if it is worse than `worst`. Returns the figure
/// of each spot.
std::vector<std::uint32_t> takeWorse(const Criterion& criterion, RunsOfDay& day, bool former,
                                     std::optional<WorstSpot>& worst) {
    const SpotRuns& runs = day.count(criterion.quantity, former, {criterion.runs, criterion.dropShorterMin});
    const std::vector<std::uint32_t>& all = stepsOf(runs, criterion.measure);
    std::vector<std::uint32_t> steps = all;
    leaveOutBeside(day.shadow(), criterion.quantity, steps);
    if (steps.empty()) return all;
    const bool minimum = criterion.quantity == Quantity::sun;
    const auto found = minimum ? std::ranges::min_element(steps) : std::ranges::max_element(steps);
    if (worst && (minimum ? *found >= worst->steps : *found <= worst->steps)) return all;
    worst = WorstSpot{*found, runsOf(runs, std::size_t(found - steps.begin()))};
    return all;
}

/// By how many steps a spot may be worse than the worst that was found.
double findExcessSteps(Quantity quantity, std::uint32_t bound, std::uint32_t worst) {
    const double excess = double(bound) - double(worst);
    return std::max(0.0, quantity == Quantity::sun ? -excess : excess);
}

/// The worst that a spot of any cell may be where only centres were looked at; else of the cells that no
/// point lies in. None: points lie in all that may be worse than the worst centre.
std::optional<std::uint32_t> boundOfTheRest(const Criterion& criterion, const DayShadow& day,
                                            const std::vector<std::uint32_t>& steps) {
    const Quantity quantity = criterion.quantity;
    if (!day.spots().empty()) return listSuspects(day.shadow(), quantity, steps).next;
    const auto bounds = boundSpots(day.shadow(), quantity, steps);
    return quantity == Quantity::sun ? std::ranges::min(bounds) : std::ranges::max(bounds);
}

/// Minutes and runs of the worst spot. A spot may be worse by as much as the nearest points were worse than
/// all others, and one of a cell that no point lies in by what lies between that cell and those beside it.
Measured measureWorstSpot(const Criterion& criterion, const DayShadow& day, bool former) {
    std::optional<WorstSpot> worst;
    const std::vector<std::uint32_t> steps = takeWorse(criterion, day.runs().front(), former, worst);
    if (!worst) return {};
    double beyond = 0;
    for (RunsOfDay& spots : day.runs().subspan(1)) {
        const double before = worst->steps;
        takeWorse(criterion, spots, former, worst);
        beyond = std::abs(before - double(worst->steps));
    }
    if (const auto bound = boundOfTheRest(criterion, day, steps))
        beyond = std::max(beyond, findExcessSteps(criterion.quantity, *bound, worst->steps));
    Measured measured = measureSpot(criterion, worst->runs, {day.stepMin(), day.runErrorMin()});
    if (criterion.quantity == Quantity::sun)
        measured.low = std::max(0.0, measured.low - beyond * day.stepMin());
    else
        measured.high += beyond * day.stepMin();
    return measured;
}

/// How many cells each cell of a place counts.
std::vector<double> weightsOf(const PlaceShadow& shadow) {
    std::vector<double> weights(shadow.baseline.receivers, 1.0);
    for (const WeightedCell& cell : shadow.uneven) weights[cell.bit] += cell.extra;
    return weights;
}

/// The spots of a place for which a condition holds: surely, as measured, and possibly.
class MeetingSpots {
public:
    explicit MeetingSpots(const PlaceShadow& shadow)
        : shadow_(shadow), weights_(weightsOf(shadow)), words_((weights_.size() + 63) / 64) {}

    void take(std::size_t cell, bool surely, bool measured, bool possibly) {
        const std::array<bool, 3> holds{surely, measured, possibly};
        for (std::size_t bound = 0; bound < holds.size(); ++bound)
            if (holds[bound]) cells_[bound] += 1, sums_[bound] += weights_[cell];
        if (measured) words_[cell / 64] |= std::uint64_t{1} << cell % 64;
    }
    [[nodiscard]] bool isEverySpot() const { return cells_[0] == weights_.size(); }

    /// In cells. A cell on the edge of these spots may be in or out; where all or none are in there is none.
    [[nodiscard]] Measured count() const {
        const double edge = edgeErrorCells(countEdges(words_, shadow_.neighbours));
        return {sums_[1], isEverySpot() ? sums_[0] : std::max(0.0, sums_[0] - edge),
                cells_[2] == 0 ? 0 : sums_[2] + edge};
    }

private:
    const PlaceShadow& shadow_;
    std::vector<double> weights_;
    std::vector<std::uint64_t> words_;
    std::array<std::size_t, 3> cells_{};
    std::array<double, 3> sums_{};
};

RunSettings runSettingsOf(const Criterion& criterion) {
    return {runsWanted(criterion), criterion.dropShorterMin};
}

Measured measureShare(const Criterion& criterion, const DayShadow& day, bool former) {
    const PlaceShadow& shadow = day.shadow();
    const SpotRuns& runs = day.runs().front().count(criterion.quantity, former, runSettingsOf(criterion));
    const RunError error{day.stepMin(), day.runErrorMin()};
    MeetingSpots spots(shadow);
    for (std::size_t cell = 0; cell < runs.total.size(); ++cell) {
        const auto met = [&](int sign) { return meets(criterion.spot, runsOf(runs, cell), error, sign); };
        spots.take(cell, met(-1), met(0), met(1));
    }
    if (day.areaM2() <= 0) return {};
    const Measured cells = spots.count();
    const auto share = [&](double count) {
        return std::clamp(count * shadow.cellAreaM2 / day.areaM2(), 0.0, 1.0);
    };
    // Exactly 1 where no spot is within its error: shares of cells leave a rounding error.
    if (spots.isEverySpot()) return {1, 1, 1};
    return {share(cells.value), share(cells.low), share(cells.high)};
}

/// Whether a spot has more minutes than the criterion's, and more than in the baseline: surely, as measured,
/// and possibly.
struct ExcessOfSpot {
    bool surely = false, measured = false, possibly = false;
};

ExcessOfSpot findExcess(const Criterion& criterion, const RunCounts& now, const RunCounts& former,
                        bool isMore, const RunError& error) {
    const double limit = criterion.spot.minutes, minutes = now.total * error.stepMin,
                 before = former.total * error.stepMin;
    const double off = now.count * error.runErrorMin, formerOff = former.count * error.runErrorMin;
    // Where nothing comes to what the baseline shades there is no more of it, whatever the steps miss.
    return {isMore && minutes - off > limit && minutes - off > before + formerOff,
            isMore && minutes > limit && minutes > before,
            isMore && minutes + off >= limit && minutes + off > before - formerOff};
}

/// Calls `take(spot, excess)` for each spot.
void findExcesses(const Criterion& criterion, RunsOfDay& day, const RunError& error, const auto& take) {
    const RunSettings settings = runSettingsOf(criterion);
    const SpotRuns &now = day.count(criterion.quantity, false, settings),
                   &former = day.count(criterion.quantity, true, settings);
    const std::vector<bool> more = findSpotsWithMore(day.shadow(), criterion.quantity);
    for (std::size_t spot = 0; spot < now.total.size(); ++spot)
        take(spot, findExcess(criterion, runsOf(now, spot), runsOf(former, spot), more[spot], error));
}

/// The area of the spots with more than the criterion's minutes, of all cells by their shares of the place,
/// as every area. Points near the worst spots have no area; where one exceeds them and no cell does, a cell
/// may.
Measured measureAreaOver(const Criterion& criterion, const DayShadow& day) {
    const RunError error{day.stepMin(), day.runErrorMin()};
    const double cellM2 = day.shadow().cellAreaM2;
    MeetingSpots cells(day.shadow());
    findExcesses(criterion, day.runs().front(), error, [&](std::size_t cell, const ExcessOfSpot& excess) {
        cells.take(cell, excess.surely, excess.measured, excess.possibly);
    });
    const Measured count = cells.count();
    bool anyPoint = false;
    for (RunsOfDay& points : day.runs().subspan(1))
        findExcesses(criterion, points, error, [&](std::size_t, const ExcessOfSpot& excess) {
            anyPoint = anyPoint || excess.possibly;
        });
    return {count.value * cellM2, count.low * cellM2, std::max(count.high, anyPoint ? 1.0 : 0.0) * cellM2};
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

/// Narrows the range of a sum over days to so much on both sides: the days' errors are independent of each
/// other, as shadows fall anew on the cells and steps of each. Three standard deviations of errors that are
/// spread evenly within the days' ranges.
void narrow(Measured& sum, double error) {
    sum.low = std::max(sum.low, sum.value - error);
    sum.high = std::min(sum.high, sum.value + error);
}

/// Whether more of the value is worse: by the first limit, or by the quantity.
bool isWorseWhenHigher(const Criterion& criterion) {
    if (criterion.limits.empty())
        return criterion.quantity != Quantity::sun && criterion.measure != Measure::share;
    const Comparison comparison = criterion.limits.front().comparison;
    return comparison == Comparison::atMost || comparison == Comparison::below;
}

}  // namespace

Measured measureDay(const Criterion& criterion, const DayShadow& day, bool former) {
    const Quantity quantity = criterion.quantity;
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
            return measureLargestArea(day, quantity, former);
        case Measure::largestShare:
            return measureLargestShare(day, quantity, former);
        case Measure::areaHours:
            return measureAreaHours(day, quantity, former);
        case Measure::areaOver:
            return measureAreaOver(criterion, day);
        case Measure::skyComponent:  // of windows
        case Measure::probableSun:
            return {};
    }
    return {};
}

Rule dropComparisons(Rule rule) {
    if (std::ranges::none_of(rule.criteria, comparesFormer)) return rule;
    for (Criterion& criterion : rule.criteria) std::erase_if(criterion.limits, &Limit::ofFormer);
    const auto isOnlyStated = [&](const std::string& key) {
        const auto criterion = std::ranges::find(rule.criteria, key, &Criterion::key);
        return criterion != rule.criteria.end() && criterion->limits.empty();
    };
    std::erase_if(rule.alternatives, [&](const std::vector<std::string>& criteria) {
        return std::ranges::any_of(criteria, isOnlyStated);
    });
    rule.readings.emplace_back("Without a proposal, limits relative to the baseline are left out");
    return rule;
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

bool CriterionDays::decidesOver(Verdict verdict, double value) const {
    if (!found_.value) return true;
    const bool wantsWorst = combination_ != DayCombination::chosen;
    if (verdict != found_.verdict) return (verdict > found_.verdict) == wantsWorst;
    const bool worse =
        isWorseWhenHigher(*criterion_) ? value > found_.value->value : value < found_.value->value;
    return value != found_.value->value && worse == wantsWorst;
}

void CriterionDays::takeDay(CivilDate day, const Measured& value, const std::optional<Measured>& former,
                            bool unchanged) {
    const Verdict verdict = judgeLimits(*criterion_, value, former, unchanged);
    found_.failingDays += verdict == Verdict::fail ? 1 : 0;
    found_.borderlineDays += verdict == Verdict::borderline ? 1 : 0;
    if (!decidesOver(verdict, value.value)) return;
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
    const double half = weight * (value.high - value.low) / 2;
    squaredErrors_ += half * half;
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
    if (criterion_->measure == Measure::areaHours) narrow(*result.value, std::sqrt(3 * squaredErrors_) / by);
    if (hasFormer_) result.former = divided(formerSum_, by);
    result.verdict = judgeLimits(*criterion_, *result.value, result.former, unchanged_);
    return result;
}

}  // namespace noonmark
