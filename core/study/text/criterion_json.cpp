#include "core/study/text/criterion_json.h"

#include <cmath>

#include "core/review/library/rule_text.h"
#include "core/review/rule/rule_names.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

double round4(double value) { return std::round(value * 1e4) / 1e4; }

Json numberOrNull(double value) { return std::isfinite(value) ? Json(round4(value)) : Json(); }

Json measuredJson(const std::optional<Measured>& measured) {
    if (!measured) return {};
    return {{"value", numberOrNull(measured->value)},
            {"low", numberOrNull(measured->low)},
            {"high", numberOrNull(measured->high)}};
}

static Json limitJson(const Limit& limit) {
    return {{"compare", ruleNameOf(comparisonNames(), limit.comparison)},
            {limit.isLoss     ? "loss"
             : limit.ofFormer ? "former_ratio"
                              : "value",
             limit.value},
            {"status", ruleNameOf(figureStatusNames(), limit.evidence.status)},
            {"source", limit.evidence.source}};
}

Json criterionJson(const Criterion& criterion, const CriterionResult& result) {
    Json limits = Json::array();
    for (const Limit& limit : criterion.limits) limits.push_back(limitJson(limit));
    return {{"key", criterion.key},
            {"name", criterion.name},
            {"unit", unitOf(criterion.measure)},
            {"verdict", nameOf(result.verdict)},
            {"advisory", criterion.advisory},
            {"measured", measuredJson(result.value)},
            {"former", measuredJson(result.former)},
            {"limits", limits},
            {"day", result.day ? Json(formatText(*result.day)) : Json()},
            {"days", result.days},
            {"failing_days", result.failingDays},
            {"borderline_days", result.borderlineDays}};
}

Json ruleJson(const Rule& rule) {
    Json figures = Json::array(), chosen = Json::object();
    for (const auto& [choice, option] : rule.chosen) chosen[choice] = option;
    for (const StatedFigure& figure : rule.figures)
        figures.push_back({{"text", figure.text},
                           {"status", ruleNameOf(figureStatusNames(), figure.evidence.status)},
                           {"source", figure.evidence.source}});
    return {{"rule_name", rule.name},
            {"choices", chosen},
            {"status", ruleNameOf(figureStatusNames(), leastSure(rule))},
            {"readings", rule.readings},
            {"figures", figures}};
}

}  // namespace noonmark
