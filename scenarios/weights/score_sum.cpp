#include "scenarios/weights/score.h"

#include <algorithm>
#include <limits>

namespace noonmark {

namespace {

using namespace std::chrono;

struct WallTime {
    CivilDate date;
    minutes timeOfDay;
};

WallTime wallTimeOf(const SunStep& step, const Zone& zone) {
    const auto at = floor<seconds>(step.at);
    const auto local = at + zone.offsetAt(at);
    const auto day = floor<days>(local);
    return {CivilDate(day), floor<minutes>(local - day)};
}

std::optional<std::size_t> intervalAt(const TimeWeights& weights, const WallTime& time) {
    for (std::size_t i = 0; i < weights.intervals.size(); ++i)
        if (weights.intervals[i].holds(time.date, time.timeOfDay)) return i;
    return std::nullopt;
}

TimePiece& pieceFor(std::vector<TimePiece>& pieces, year_month month, std::optional<std::size_t> interval,
                    double stepMinutes) {
    for (TimePiece& piece : pieces)
        if (piece.month == month && piece.interval == interval) return piece;
    pieces.push_back({month, interval, {.stepMinutes = stepMinutes}, {}});
    return pieces.back();
}

void add(TimePiece& piece, const SunSteps& whole, std::uint32_t number, CivilDate dayOf) {
    SunSteps& sun = piece.sun;
    if (sun.days.empty() || sun.days.back().date != dayOf)
        sun.days.push_back({.date = dayOf, .first = std::uint32_t(sun.steps.size())});
    sun.steps.push_back(whole.steps[number]);
    piece.steps.push_back(number);
    ++sun.days.back().count;
}

}  // namespace

std::vector<TimePiece> splitIntoPieces(const SunSteps& sun, const Zone& zone, const TimeWeights& weights) {
    std::vector<TimePiece> pieces;
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i) {
            const WallTime time = wallTimeOf(sun.steps[i], zone);
            const year_month month{time.date.year(), time.date.month()};
            add(pieceFor(pieces, month, intervalAt(weights, time), sun.stepMinutes), sun, i, day.date);
        }
    return pieces;
}

StepSets makeSets(const std::vector<TimePiece>& pieces, const SunSteps& sun) {
    StepSets sets{std::vector<std::string>(pieces.size()), std::vector<std::uint16_t>(sun.steps.size())};
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (const std::uint32_t step : pieces[i].steps) sets.ofStep[step] = std::uint16_t(i);
    return sets;
}

namespace {

std::vector<double> sunlitOf(const std::vector<TimePiece>& pieces, std::size_t intervals) {
    std::vector<double> minutes(intervals, 0);
    for (const TimePiece& piece : pieces)
        if (piece.interval) minutes[*piece.interval] += piece.sun.sunlitMinutes();
    return minutes;
}

MonthFigures& figuresFor(std::vector<MonthFigures>& months, std::chrono::year_month month) {
    const auto found = std::ranges::find(months, month, &MonthFigures::month);
    if (found != months.end()) return *found;
    return months.emplace_back(MonthFigures{.month = month});
}

}  // namespace

ScoreSum::ScoreSum(const Receivers& receivers, const TimeWeights& weights,
                   const std::vector<TimePiece>& pieces)
    : receivers_(receivers),
      weights_(weights),
      sunlit_(sunlitOf(pieces, weights.intervals.size())),
      sum_(receivers.grid.size(), 0) {
    for (const WeightedInterval& interval : weights.intervals)
        score_.intervals.push_back({interval.name, interval.weight});
}

void ScoreSum::add(const TimePiece& piece, const std::vector<float>& minutes, double factor) {
    const double cellM2 = receivers_.grid.cellAreaM2();
    const double perMinute = piece.interval ? 1 / sunlit_[*piece.interval] : 0;
    const double weight = piece.interval ? weights_.intervals[*piece.interval].weight : 0;
    double all = 0;
    for (const std::uint32_t cell : receivers_.cells) {
        const double shaded = double(minutes[cell]) * factor;
        all += shaded;
        sum_[cell] += weight * shaded * perMinute;
    }
    MonthFigures& month = figuresFor(score_.months, piece.month);
    month.sunlitMinutes += piece.sun.sunlitMinutes();
    month.shadowAreaM2 += all * cellM2;
    month.scoreM2 += weight * all * perMinute * cellM2;
    const double weightedM2h = weight * all / 60 * cellM2;
    month.weightedShadeM2h += weightedM2h;
    score_.weightedShadeM2h += weightedM2h;
    if (!piece.interval) return;
    IntervalFigures& interval = score_.intervals[*piece.interval];
    interval.shadowAreaM2 += all * perMinute * cellM2;
    interval.weightedShadeM2h += weightedM2h;
}

Score ScoreSum::finish() && {
    score_.grid = receivers_.grid;
    score_.score.assign(sum_.size(), std::numeric_limits<float>::quiet_NaN());
    for (const std::uint32_t cell : receivers_.cells) {
        score_.score[cell] = float(sum_[cell]);
        score_.scoreM2 += sum_[cell] * receivers_.grid.cellAreaM2();
    }
    score_.receiverAreaM2 = double(receivers_.cells.size()) * receivers_.grid.cellAreaM2();
    score_.waterM2 =
        double(std::ranges::count(receivers_.kind, CellKind::water)) * receivers_.grid.cellAreaM2();
    for (MonthFigures& month : score_.months) month.shadowAreaM2 /= month.sunlitMinutes;
    for (IntervalFigures& interval : score_.intervals)
        interval.scoreM2 = interval.weight * interval.shadowAreaM2;
    std::ranges::sort(score_.months, {}, &MonthFigures::month);
    return std::move(score_);
}

}  // namespace noonmark
