#include "core/study/text/review_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/csv_text.h"
#include "core/base/json_number.h"
#include "core/base/version.h"
#include "core/base/wording.h"
#include "core/describe/figure_text.h"
#include "core/describe/fill_text.h"
#include "core/describe/text.h"
#include "core/review/library/rule_text.h"
#include "core/review/places/review_columns.h"
#include "core/review/places/verdict_text.h"
#include "core/review/rule/rule_names.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/text/error_text.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

double round4(double value) { return roundAsText(value, 4); }

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
            {"status", ruleNameOf(figureStatusNames(), findLeastCertain(rule))},
            {"readings", rule.readings},
            {"trees", ruleNameOf(ruleTreesNames(), rule.occluders.trees)},
            {"figures", figures}};
}

namespace {

Json timeOrNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json utcOrNull(const std::optional<Instant>& at) {
    return at ? Json(Zone::utc().text(std::chrono::round<std::chrono::seconds>(*at))) : Json();
}

Json rowJson(const PlaceReview& review, const ReviewRow& row) {
    Json json{{"day", formatText(row.day)},
              {"enters", timeOrNull(row.entersText)},
              {"exits", timeOrNull(row.exitsText)},
              {"enters_utc", utcOrNull(row.enters)},
              {"exits_utc", utcOrNull(row.exits)},
              {"max_at", timeOrNull(row.maxAtText)},
              {"weight", row.weight}};
    json.update(figuresJson(reviewRowFigures().of(row)));
    Json criteria = Json::object();
    for (std::size_t i = 0; i < review.criteria.size(); ++i)
        criteria[review.criteria[i].key] = row.criteria[i] ? numberOrNull(*row.criteria[i]) : Json();
    json["criteria"] = criteria;
    return json;
}

Json totalsJson(const ReviewTotals& totals) {
    const auto share = [&](double m2h) {
        return totals.theoreticalM2h > 0 ? Json(m2h / totals.theoreticalM2h) : Json();
    };
    return {{"days", totals.days},
            {"days_with_incremental", totals.daysWithIncremental},
            {"sun_hours", round4(totals.sunHours)},
            {"theoretical_m2h", round4(totals.theoreticalM2h)},
            {"baseline_m2h", round4(totals.baselineM2h)},
            {"scenario_m2h", round4(totals.scenarioM2h)},
            {"incremental_m2h", round4(totals.incrementalM2h)},
            {"gained_m2h", round4(totals.gainedM2h)},
            {"baseline_share", share(totals.baselineM2h)},
            {"scenario_share", share(totals.scenarioM2h)},
            {"incremental_share", share(totals.incrementalM2h)},
            {"incremental_by_month_m2h", totals.incrementalByMonthM2h},
            {"largest_day", totals.largestDay ? Json(formatText(*totals.largestDay)) : Json()},
            {"largest_day_m2h", round4(totals.largestDayM2h)},
            {"largest_day_duration_min", round4(totals.largestDayDurationMin)}};
}

Json placeJson(const PlaceReview& review) {
    Json rows = Json::array(), criteria = Json::array();
    for (const ReviewRow& row : review.rows) rows.push_back(rowJson(review, row));
    for (std::size_t i = 0; i < review.criteria.size(); ++i)
        criteria.push_back(criterionJson(review.criteria[i], review.results[i]));
    return {{"name", review.name},
            {"kind", nameOf(review.kind)},
            {"verdict", nameOf(review.verdict)},
            {"reason", describeReason(review)},
            {"area_m2", round4(review.areaM2)},
            {"rows", rows},
            {"criteria", criteria},
            {"totals", totalsJson(review.totals)}};
}

/// The rule's own table: its titles, and the texts of each place and day.
Json tableJson(const ReviewStudy& study) {
    Json titles = Json::array(), lines = Json::array();
    for (const RuleColumn& column : study.rule.deliverables.columns) titles.push_back(column.title);
    for (const PlaceReview& review : study.places)
        for (const ReviewRow& row : review.rows) {
            Json line = Json::array();
            for (const RuleColumn& column : study.rule.deliverables.columns)
                line.push_back(columnText(review, row, column.key));
            lines.push_back(line);
        }
    return {{"columns", titles}, {"rows", lines}};
}

Json contributionsJson(const ReviewStudy& study) {
    Json all = Json::array();
    for (const ReviewContribution& building : study.contributions) {
        Json places = Json::array();
        for (std::size_t i = 0; i < study.places.size(); ++i)
            places.push_back(
                {{"name", study.places[i].name}, {"incremental_m2h", round4(building.incrementalM2h[i])}});
        all.push_back({{"id", building.id}, {"name", building.name}, {"places", places}});
    }
    return all;
}

}  // namespace

std::string describeReviewErrors(const ReviewStudy& study) {
    const auto number = [](double value) { return localNumbers(fmt::format("{:.3g}", value)); };
    std::string text = localText(NM_TEXT(
        "Each run of minutes is uncertain by a step; each area by half of the cells that its edge passes "
        "through, at least by one; each area x hours by these and by half of what the area changes from step "
        "to step, where the days of a sum err independently of each other. "));
    text +=
        study.spotDistanceM
            ? fillText(NM_TEXT("Worst spots are the worst of the cells' centres and of points around these, "
                               "down to %1 m from each other; what the nearest found worse is in their "
                               "error. "),
                       {number(*study.spotDistanceM)})
            : localText(NM_TEXT("Worst spots are the worst of the cells' centres, and their error includes "
                                "the cell. "));
    text +=
        fillText(NM_TEXT("Shadow enters and exits up to a step (%1 min) earlier than stated, as each step "
                         "has the sun of its beginning. "),
                 {number(study.stepMinutes)});
    return text + localText(NM_TEXT("A value within its error of a limit is borderline, never pass."));
}

Json reviewJson(const ReviewStudy& study, const ReviewLabels& labels) {
    Json places = Json::array();
    for (const PlaceReview& review : study.places) places.push_back(placeJson(review));
    Json json{{"rule", study.rule.key},
              {"from", labels.from},
              {"to", labels.to},
              {"places", places},
              {"trees_counted", study.trees},
              {"not_checked", study.notChecked},
              {"program", std::string("Noonmark ") + std::string(version())}};
    json.update(ruleJson(study.rule));
    json.update({{"table", tableJson(study)},
                 {"contributions", contributionsJson(study)},
                 {"year", study.year},
                 {"clock", study.clock},
                 {"engine", study.engine},
                 {"step_min", study.stepMinutes},
                 {"cell_m", study.settings.cellM},
                 {"worst_spot_distance_m", study.spotDistanceM ? Json(*study.spotDistanceM) : Json()},
                 {"error", describeReviewErrors(study)},
                 {"warnings", warningsJson(study.warnings)}});
    addProvenance(json, labels.provenance);
    addRepeat(json, makeRepeatCommand(study, labels));
    return json;
}

std::string reviewCsv(const ReviewStudy& study, const ReviewLabels& labels) {
    std::vector<Figure> figures;
    std::ranges::copy_if(reviewRowFigures().rows(), std::back_inserter(figures), &Figure::inTable);
    std::vector<std::string> columns{"rule",    "from", "to",     "place", "kind",
                                     "verdict", "day",  "enters", "exits"};
    std::ranges::move(listColumns(figures), std::back_inserter(columns));
    columns.emplace_back("reason");
    CsvText csv(columns);
    for (const PlaceReview& review : study.places)
        for (const ReviewRow& row : review.rows) {
            for (const std::string& text :
                 {study.rule.key, labels.from, labels.to, review.name, std::string(nameOf(review.kind)),
                  std::string(nameOf(review.verdict)), formatText(row.day), row.entersText, row.exitsText})
                csv.text(text);
            addFigures(csv, {figures, &row});
            csv.text(describeReason(review)).endRow();
        }
    return csv.take();
}

}  // namespace noonmark
