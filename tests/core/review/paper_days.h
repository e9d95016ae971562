#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/review/library/rule_library.h"
#include "core/review/places/place_review.h"

namespace noonmark {

// Shadow that is written down by hand: a cell is a text with a sign per step, '#' in shadow and '.' in the
// sun.

inline std::string lit(int steps) { return std::string(std::size_t(steps), '.'); }
inline std::string shaded(int steps) { return std::string(std::size_t(steps), '#'); }
using Cells = std::vector<std::string>;

inline Cells times(int count, const std::string& cell) { return Cells(std::size_t(count), cell); }
inline Cells operator+(Cells a, const Cells& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

inline StepMasks masksOf(const Cells& cells) {
    StepMasks masks(cells.size(), cells.empty() ? 0 : cells.front().size());
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
        for (std::size_t step = 0; step < masks.steps; ++step)
            if (cells[cell][step] == '#') masks.shade(step, cell);
    return masks;
}

/// One day of a place. Owns its steps.
struct PaperDay {
    std::vector<SunStep> steps;
    PlaceShadow shadow;

    PaperDay(CivilDate date, double firstMinuteUtc, double stepMin, const Cells& before, const Cells& after,
             double cellM2 = 1) {
        const std::size_t count = after.front().size();
        for (std::size_t i = 0; i < count; ++i) {
            const double minutes = firstMinuteUtc + double(i) * stepMin;
            SunStep step{{0, 0, 1}, 180, 30, std::int32_t(i), {}};
            step.at = std::chrono::sys_days{date} + std::chrono::milliseconds{std::llround(minutes * 60000)};
            steps.push_back(step);
        }
        shadow = {date, steps, cellM2, stepMin, masksOf(before), masksOf(after)};
    }
    PaperDay(const PaperDay&) = delete;
    PaperDay& operator=(const PaperDay&) = delete;
};

inline Rule shippedRule(const std::string& key, const RuleChoices& choices = {}) {
    const auto library = RuleLibrary::load();
    if (!library) throw std::runtime_error(library.error().text());
    const auto rule = library->find(key, choices);
    if (!rule) throw std::runtime_error(rule.error().text());
    return *rule;
}

inline DayClock utcClock() { return {{ClockKind::fixed, 0}, Zone::utc(), nullptr, 0}; }

inline CivilDate on(int year, unsigned month, unsigned day) {
    return std::chrono::year(year) / std::chrono::month(month) / std::chrono::day(day);
}

struct PaperPlace {
    PlaceKind kind = PlaceKind::park;
    LineBelt belt = LineBelt::none;
    double stepMin = 1;
    CivilDate date = on(2026, 3, 21);
    double cellM2 = 1;
};

/// The review of a place on one day that begins at 8:00.
inline PlaceReview reviewOf(const Rule& rule, const Cells& before, const Cells& after,
                            const PaperPlace& place = {}) {
    const DayClock clock = utcClock();
    PlaceEvaluation evaluation(rule, clock, "Green", place.kind, 0, place.belt);
    const PaperDay day(place.date, 8 * 60, place.stepMin, before, after, place.cellM2);
    evaluation.add(day.shadow);
    return evaluation.finish();
}

inline Verdict verdictOf(const Rule& rule, const Cells& before, const Cells& after,
                         const PaperPlace& place = {}) {
    return reviewOf(rule, before, after, place).verdict;
}

}  // namespace noonmark
