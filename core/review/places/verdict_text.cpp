#include "core/review/places/verdict_text.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/wording.h"
#include "core/describe/fill_text.h"
#include "core/describe/text.h"
#include "core/review/rule/rule_names.h"

namespace noonmark {

namespace {

constexpr std::string_view figuresOnly = NM_TEXT("figures only");

std::string formatMinutes(double value) {
    if (value < 60) return localNumbers(fmt::format("{:.4g}", value)) + " min";
    const double minutes = std::round(value * 10) / 10;
    const double hours = std::floor(minutes / 60);
    return minutes == hours * 60 ? fmt::format("{:.0f} h", hours)
                                 : fmt::format("{:.0f} h {} min", hours,
                                               localNumbers(fmt::format("{:.4g}", minutes - hours * 60)));
}

}  // namespace

std::string formatMeasured(Measure measure, double value, UnitSystem units) {
    switch (measure) {
        case Measure::share:
        case Measure::largestShare:
            return localNumbers(fmt::format("{:.1f} %", value * 100));
        case Measure::skyComponent:
        case Measure::probableSun:
            return localNumbers(fmt::format("{:.1f} %", value));
        case Measure::areaOver:
        case Measure::largestArea:
            return formatSmallArea(value, units);
        case Measure::areaHours:
            return formatAreaHours(value, units);
        default:
            return formatMinutes(value);
    }
}

std::string describeLimit(const Criterion& criterion, const Limit& limit, UnitSystem units) {
    const std::string value =
        limit.ofFormer && !limit.isLoss
            ? fillText(NM_TEXT("%1 x former"), {localNumbers(fmt::format("{:g}", limit.value))})
            : formatMeasured(criterion.measure, limit.value, units);
    if (limit.isLoss)
        return fillText(NM_TEXT("loss %1"),
                        {fmt::format("{} {}", ruleNameOf(comparisonNames(), limit.comparison), value)});
    return fmt::format("{} {}", ruleNameOf(comparisonNames(), limit.comparison), value);
}

std::string describeLimits(const Criterion& criterion, UnitSystem units) {
    std::string text;
    for (const Limit& limit : criterion.limits)
        text = text.empty() ? describeLimit(criterion, limit, units)
                            : fillText(NM_TEXT("%1 or %2"), {text, describeLimit(criterion, limit, units)});
    return text;
}

std::string describeResult(const Criterion& criterion, const CriterionResult& result, UnitSystem units,
                           WriteDate writeDate) {
    std::string text = fmt::format("{}: {}", localRuleText(criterion.name),
                                   formatMeasured(criterion.measure, result.value->value, units));
    if (result.former)
        text += fillText(NM_TEXT(" (former %1)"),
                         {formatMeasured(criterion.measure, result.former->value, units)});
    if (result.day) text += fillText(NM_TEXT(" on %1"), {writeDate(*result.day)});
    return text + fillText(NM_TEXT(", wanted %1"), {describeLimits(criterion, units)});
}

std::string_view nameVerdict(const PlaceReview& review) {
    if (review.reasonNotJudged == noLimitForPlace) return figuresOnly;
    return nameOf(review.verdict);
}

std::string_view nameResult(const Criterion& criterion, const CriterionResult& result) {
    return criterion.limits.empty() ? figuresOnly : nameOf(result.verdict);
}

std::string describeReason(const PlaceReview& review, UnitSystem units, WriteDate writeDate) {
    if (!review.deciding) return localText(review.reasonNotJudged);
    return describeResult(review.criteria[*review.deciding], review.results[*review.deciding], units,
                          writeDate);
}

}  // namespace noonmark
