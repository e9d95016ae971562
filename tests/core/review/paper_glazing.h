#pragma once

#include "core/review/glazing/building_review.h"
#include "tests/core/review/paper_days.h"

namespace noonmark {

// Sun on windows that is written down by hand, with the signs of paper_days.h.

struct PaperDays {
    std::vector<CivilDate> dates{on(2026, 3, 21)};
    double firstMinute = 8 * 60;  ///< of each day, UTC
    double stepMin = 1;
    std::vector<double> weights;  ///< none: 1 each
};

/// The steps of a rule: as many on each day.
inline RuleSun paperSun(const PaperDays& days, std::size_t stepsADay) {
    RuleSun sun{{}, days.weights, utcClock(), 2026};
    sun.sun.stepMinutes = days.stepMin;
    sun.weights.resize(days.dates.size(), 1);
    for (const CivilDate date : days.dates) {
        sun.sun.days.push_back({date, std::uint32_t(sun.sun.steps.size()), std::uint32_t(stepsADay), 0});
        for (std::size_t i = 0; i < stepsADay; ++i) {
            SunStep step{{0, -0.8F, 0.6F}, 180, 37, std::int32_t(i), {}};
            const double minutes = days.firstMinute + double(i) * days.stepMin;
            step.at = std::chrono::sys_days{date} + std::chrono::milliseconds{std::llround(minutes * 60000)};
            sun.sun.steps.push_back(step);
        }
    }
    return sun;
}

inline ShadedSteps stepsOf(const std::string& signs) {
    ShadedSteps shaded;
    for (const char sign : signs) shaded.push_back(sign == '#' ? 1 : 0);
    return shaded;
}

struct PaperGlazing {
    std::optional<double> azimuthDeg = 180;
    double skyPct = 40, formerSkyPct = 40;
    bool isNew = false;  ///< its building is not in the baseline
    std::string building = "house";
};

/// The review of a window; `before` and `after`: all days one after the other.
inline GlazingReview windowOf(const Rule& rule, const std::string& before, const std::string& after,
                              const PaperDays& days = {}, const PaperGlazing& window = {}) {
    const RuleSun sun = paperSun(days, after.size() / days.dates.size());
    GlazingSunlight light{.after = stepsOf(after)};
    if (!window.isNew) light.before = stepsOf(before);
    light.skyComponentPct = window.skyPct;
    light.formerSkyComponentPct = window.formerSkyPct;
    ReviewedGlazing described{.id = "w", .building = window.building};
    described.azimuthDeg = window.azimuthDeg;
    return reviewGlazing(rule, sun, described, light);
}

/// The same where only the scenario matters.
inline Verdict glazingVerdict(const Rule& rule, const std::string& sun, const PaperDays& days = {},
                              const PaperGlazing& window = {}) {
    return windowOf(rule, sun, sun, days, window).verdict;
}

}  // namespace noonmark
