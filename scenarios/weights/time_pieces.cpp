#include "scenarios/weights/time_pieces.h"

#include <algorithm>

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

}  // namespace noonmark
