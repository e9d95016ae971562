#include "core/study/glazing/glazing_text.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/base/version.h"
#include "core/describe/command_options.h"
#include "core/describe/text.h"
#include "core/review/library/rule_text.h"
#include "core/review/rule/rule_names.h"
#include "core/study/elements/element_fields.h"
#include "core/study/elements/element_tables.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/repeat_command.h"
#include "core/study/review_study.h"
#include "core/study/text/error_text.h"
#include "core/study/text/review_text.h"

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
    measure.unit =
        subject == Subject::sky ? NM_TEXT("% of the sky's light") : NM_TEXT("% of the year's probable sun");
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

namespace {

using Json = nlohmann::ordered_json;

std::string columnOf(const Criterion& criterion, const char* when) {
    std::string name = criterion.key;
    std::ranges::replace(name, '-', '_');
    return fmt::format("{}_{}", name, when);
}

std::vector<ElementColumn> glazingColumns(const Rule& rule) {
    const std::string text;
    std::vector<ElementColumn> columns{{"id", text},
                                       {"building", text},
                                       {"building_name", text},
                                       {"floor", std::int64_t(0)},
                                       {"azimuth_deg", 0.0},
                                       {"windows", std::int64_t(0)}};
    for (const Criterion& criterion : rule.criteria) {
        columns.push_back({columnOf(criterion, "before"), 0.0});
        columns.push_back({columnOf(criterion, "after"), 0.0});
    }
    for (const char* name :
         {"day", "bands_before", "bands_after", "verdict_before", "verdict_after", "reason"})
        columns.push_back({name, text});
    for (const char* name : {"lon_deg", "lat_deg"}) columns.push_back({name, 0.0, placeDecimals});
    columns.push_back({"elevation_m", 0.0});
    for (const char* name : sourceColumnNames) columns.push_back({name, text});
    return columns;
}

ElementValue textOrNothing(const std::string& text) { return text.empty() ? ElementValue() : text; }

ElementValue valueOrNothing(const std::optional<Measured>& value) {
    return value ? ElementValue(value->value) : ElementValue();
}

std::vector<ElementValue> glazingRow(const GlazingStudy& study, std::size_t index) {
    const GlazingReview& review = study.windows[index];
    const ReviewedGlazing& window = review.window;
    std::vector<ElementValue> row{window.id,
                                  textOrNothing(window.building),
                                  textOrNothing(window.buildingName),
                                  std::int64_t(window.floor),
                                  window.azimuthDeg ? ElementValue(*window.azimuthDeg) : ElementValue(),
                                  std::int64_t(window.windows)};
    for (const CriterionResult& result : review.results) {
        row.push_back(valueOrNothing(result.former));
        row.push_back(valueOrNothing(result.value));
    }
    const CivilDate day = review.day.value_or(CivilDate{});
    row.insert(row.end(),
               {review.day ? ElementValue(formatText(day)) : ElementValue(),
                textOrNothing(bandsText(study, day, review.formerBands)),
                textOrNothing(bandsText(study, day, review.bands)), std::string(nameOf(review.formerVerdict)),
                std::string(nameOf(review.verdict)), describeReason(study.rule, review)});
    const glm::dvec3 place = study.places[index];
    row.insert(row.end(), {place.x, place.y, place.z});
    return row;
}

Json bandsJson(const GlazingStudy& study, CivilDate day, const std::vector<SunBand>& bands) {
    Json all = Json::array();
    for (const SunBand& band : bands)
        all.push_back({{"from", study.clock.timeText(day, band.from)},
                       {"to", study.clock.timeText(day, band.to)},
                       {"minutes", round4(band.minutes())}});
    return all;
}

Json glazingJson(const GlazingStudy& study, const GlazingReview& review) {
    const ReviewedGlazing& window = review.window;
    Json criteria = Json::array();
    for (std::size_t i = 0; i < review.results.size(); ++i) {
        Json one = criterionJson(study.rule.criteria[i], review.results[i]);
        one["verdict_before"] = nameOf(review.formerVerdicts[i]);
        criteria.push_back(std::move(one));
    }
    const CivilDate day = review.day.value_or(CivilDate{});
    return {{"id", window.id},
            {"building", window.building.empty() ? Json() : Json(window.building)},
            {"floor", window.floor},
            {"azimuth_deg", window.azimuthDeg ? numberOrNull(*window.azimuthDeg) : Json()},
            {"windows", window.windows},
            {"verdict", nameOf(review.verdict)},
            {"verdict_before", nameOf(review.formerVerdict)},
            {"reason", describeReason(study.rule, review)},
            {"day", review.day ? Json(formatText(day)) : Json()},
            {"bands", bandsJson(study, day, review.bands)},
            {"bands_before", bandsJson(study, day, review.formerBands)},
            {"criteria", criteria}};
}

Json countsJson(const VerdictCounts& counts) {
    return {{"pass", counts.pass},
            {"borderline", counts.borderline},
            {"fail", counts.fail},
            {"not_applicable", counts.notJudged()}};
}

Json changesJson(const VerdictChanges& changes) {
    return {{"before", countsJson(changes.before)},
            {"after", countsJson(changes.after)},
            {"worse", changes.worse},
            {"better", changes.better}};
}

Json buildingJson(const Rule& rule, const BuildingReview& building) {
    Json shares = Json::array();
    for (std::size_t i = 0; i < building.shares.size(); ++i) {
        const BuildingShare& share = building.shares[i];
        shares.push_back({{"name", rule.shares[i].name},
                          {"at_least", rule.shares[i].atLeast},
                          {"units", share.units},
                          {"meeting", share.meeting},
                          {"borderline", share.borderline},
                          {"meeting_before", building.formerShares[i].meeting},
                          {"verdict", nameOf(share.verdict)}});
    }
    return {{"id", building.id.empty() ? Json() : Json(building.id)},
            {"name", building.name},
            {"verdict", nameOf(building.verdict)},
            {"verdict_before", nameOf(building.formerVerdict)},
            {"windows", changesJson(building.windows)},
            {"shares", shares}};
}

}  // namespace

std::string valueText(const Criterion& criterion, const std::optional<Measured>& value) {
    if (!value) return "-";
    const bool isPercent =
        criterion.measure == Measure::skyComponent || criterion.measure == Measure::probableSun;
    return isPercent ? fmt::format("{:.1f} %", value->value) : fmt::format("{:.4g}", value->value);
}

std::string bandsText(const GlazingStudy& study, CivilDate day, const std::vector<SunBand>& bands) {
    std::string text;
    for (const SunBand& band : bands)
        text += fmt::format("{}{}-{}", text.empty() ? "" : " ", study.clock.timeText(day, band.from),
                            study.clock.timeText(day, band.to));
    return text;
}

ElementTable makeGlazingTable(const GlazingStudy& study, const ReviewLabels& labels) {
    ElementTable table{.columns = glazingColumns(study.rule), .places = study.places};
    const auto source = sourceValues(labels.provenance);
    for (std::size_t i = 0; i < study.windows.size(); ++i) {
        table.rows.push_back(glazingRow(study, i));
        for (const std::string& value : source) table.rows.back().emplace_back(value);
    }
    return table;
}

Json glazingReviewJson(const GlazingStudy& study, const ReviewLabels& labels) {
    Json windows = Json::array(), buildings = Json::array(), seconds = Json::object();
    for (const GlazingReview& review : study.windows) windows.push_back(glazingJson(study, review));
    for (const BuildingReview& building : study.buildings)
        buildings.push_back(buildingJson(study.rule, building));
    for (const auto& [stage, time] : study.seconds) seconds[stage] = round4(time);
    Json json{
        {"rule", study.rule.key},
        {"from", labels.from},
        {"to", labels.to},
        {"counts",
         {{"windows", changesJson(study.windowChanges)}, {"buildings", changesJson(study.buildingChanges)}}},
        {"buildings", buildings},
        {"windows", windows},
        {"trees_counted", study.trees},
        {"not_checked", study.notChecked},
        {"program", std::string("Noonmark ") + std::string(version())}};
    json.update(ruleJson(study.rule));
    json.update(
        {{"year", study.year},
         {"clock", study.clock.text()},
         {"engine", study.engine},
         {"step_min", study.stepMinutes},
         {"steps", study.steps},
         {"error",
          fmt::format(
              "Each run is uncertain by a step, a sky component by {:g} %; a value within its error of "
              "the limit is borderline",
              skyComponentErrorPct)},
         {"seconds", seconds},
         {"warnings", warningsJson(study.warnings)}});
    addProvenance(json, labels.provenance);
    if (study.glazingInput) json["windows_file"] = inputsJson({*study.glazingInput});
    addRepeat(json, makeRepeatCommand(study, labels));
    return json;
}

std::vector<CommandOption> makeRepeatOptions(const ElementSettings& windows) {
    std::vector<CommandOption> options = listElementOptions(windows);
    // The command measures nothing but windows, in their middle.
    std::erase_if(options, [](const CommandOption& option) {
        return hasFlag(receiverFields().rows(), option.name) ||
               hasFlag(aboveFloorFields().rows(), option.name);
    });
    if (windows.places == ElementPlaces::facades && !windows.proposed && windows.buildings.empty())
        options.insert(options.begin(),
                       {std::string(facadesOfFields().rows().front().flag), {std::string(allFacades)}});
    return options;
}

Result<std::string> makeRepeatCommand(const GlazingStudy& study, const ReviewLabels& labels,
                                      std::size_t width) {
    const Provenance& provenance = labels.provenance;
    const bool ofFiles = !provenance.project && namesCityFiles(provenance);
    if (!ofFiles && (!provenance.project || !provenance.project->saved()))
        return failure(
            "No command can repeat this review yet: the project has not been saved in the state "
            "that was reviewed",
            fmt::format("scenario '{}'", labels.to), "Save the project, then review again");
    CommandLineText line("noonmark-cli review run");
    if (ofFiles)
        addCityFiles(line, provenance);
    else
        line.file(provenance.project->file);
    addRule(line, study.rule);
    if (!ofFiles) line.option(flags::from, labels.from);
    if (!ofFiles) line.option(flags::to, labels.to);
    line.option({std::string(flagOf(reviewFields().rows(), "year")), {fmt::to_string(study.year)}});
    line.option({std::string(flagOf(reviewFields().rows(), "zone")), {study.settings.zone}});
    for (const CommandOption& option : labels.sheets) line.option(option);
    line.option(flags::out, "repeated");
    return line.wrapped(width);
}

}  // namespace noonmark
