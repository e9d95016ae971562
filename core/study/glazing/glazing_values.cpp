#include "core/study/glazing/glazing_values.h"

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

enum class Subject { time, sky, probableSun };

Subject subjectOf(const Criterion& criterion) {
    if (criterion.measure == Measure::skyComponent) return Subject::sky;
    return criterion.measure == Measure::probableSun ? Subject::probableSun : Subject::time;
}

/// In minutes or percent; 0 where the criterion has none of its own.
double limitOf(const Criterion& criterion) {
    if (criterion.measure == Measure::share) return criterion.spot.minutes;
    for (const Limit& limit : criterion.limits)
        if (!limit.ofFormer) return limit.value;
    return 0;
}

LegendScale hours(double top) {
    const bool isWhole = top == std::floor(top) && top >= 3;
    return {top, isWhole ? 1 : 0.5};
}

LegendScale percent(double top) { return {top, top <= 25 ? 5.0 : 10.0}; }

void setScale(double limit, GlazingMeasure& measure, Subject subject) {
    constexpr double defaultHours = 4, defaultPct = 50,
                     wholeSkyPct = 40;  // an open wall has 39.6 % of the sky
    if (subject == Subject::time) {
        measure.unit = "hours";
        const double top = limit > 0 ? std::ceil(limit / 30) : defaultHours;
        measure.scale = hours(top);
        measure.changeScale = hours(top / 2);
        return;
    }
    measure.unit = subject == Subject::sky ? "% of the sky's light" : "% of the year's probable sun";
    double top = limit > 0 ? std::min(100.0, std::ceil(limit / 5) * 10) : defaultPct;
    if (subject == Subject::sky) top = wholeSkyPct;
    measure.scale = percent(top);
    measure.changeScale = percent(top / 2);
}

}  // namespace

std::vector<GlazingMeasure> listGlazingMeasures(const Rule& rule) {
    std::vector<GlazingMeasure> measures;
    for (const Subject subject : {Subject::time, Subject::sky, Subject::probableSun}) {
        const auto isAbout = [&](const Criterion& criterion) { return subjectOf(criterion) == subject; };
        auto found = std::ranges::find_if(rule.criteria, [&](const Criterion& criterion) {
            return isAbout(criterion) && !criterion.advisory && !criterion.limits.empty();
        });
        if (found == rule.criteria.end()) found = std::ranges::find_if(rule.criteria, isAbout);
        if (found == rule.criteria.end()) continue;
        GlazingMeasure measure{std::size_t(found - rule.criteria.begin()), found->name, {}, {}, {}};
        setScale(limitOf(*found), measure, subject);
        measures.push_back(std::move(measure));
    }
    return measures;
}

std::optional<double> shownValue(const Rule& rule, const GlazingMeasure& measure, const GlazingReview& review,
                                 bool former) {
    const Criterion& criterion = rule.criteria[measure.criterion];
    const CriterionResult& result = review.results[measure.criterion];
    const auto& value = former ? result.former : result.value;
    if (!value) return std::nullopt;
    if (subjectOf(criterion) != Subject::time) return value->value;
    if (criterion.measure != Measure::share) return value->value / 60;
    if (!review.day) return std::nullopt;
    double minutes = 0;
    for (const SunBand& band : former ? review.formerBands : review.bands) minutes += band.minutes();
    return minutes / 60;
}

}  // namespace noonmark
