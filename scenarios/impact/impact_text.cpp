#include "scenarios/impact/impact_text.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/csv_text.h"
#include "core/study/provenance/provenance_json.h"
#include "core/study/provenance/source_columns.h"
#include "core/study/text/error_json.h"
#include "core/study/text/warnings_json.h"
#include "scenarios/settings_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

Json changeJson(const ChangeFigures& figures) {
    if (std::isnan(figures.meanMin)) return nullptr;
    return {{"gained_m2", figures.gainedM2},       {"lost_m2", figures.lostM2},
            {"touched_m2", figures.touchedM2},     {"eased_m2", figures.easedM2},
            {"mean_min", figures.meanMin},         {"most_gained_min", figures.mostGainedMin},
            {"most_lost_min", figures.mostLostMin}};
}

}  // namespace

Json figuresJson(const ImpactFigures& figures) {
    return {{"threshold_min", figures.thresholdMin},
            {"receiver_area_m2", figures.receiverAreaM2},
            {"gross", changeJson(figures.gross)},
            {"continuous", changeJson(figures.continuous)},
            {"shadow_area_change_m2", figures.shadowAreaChangeM2},
            {"became_building_m2", figures.becameBuildingM2},
            {"became_ground_m2", figures.becameGroundM2}};
}

namespace {

Json figuresJson(const Impact& impact, const std::vector<double>& thresholds) {
    Json json = Json::array();
    for (const double threshold : thresholds) json.push_back(figuresJson(computeFigures(impact, threshold)));
    return json;
}

Json definitions() {
    return {{"change", "the field of `to` minus the field of `from`, same engine, steps and receivers"},
            {"error", "of the change on a sample of receivers that the ray reference traced in both cities"},
            {"gained_m2", "area where the minutes rose by more than the threshold"},
            {"touched_m2", "area where they rose at all"},
            {"shadow_area_change_m2",
             "change of the sum over receivers of (share of the sunlit time in shadow x cell area)"},
            {"by_building", "`to` minus `to` without this building: its sole contribution"},
            {"became_building_m2", "open ground in `from`, under a building in `to`: no receiver"}};
}

void addLine(CsvText& csv, const std::string& id, const std::string& name, const ImpactFigures& figures,
             const SourceValues& source) {
    const ChangeFigures &gross = figures.gross, &runs = figures.continuous;
    csv.text(id).text(name).number(figures.thresholdMin);
    for (const double m2 : {gross.gainedM2, gross.lostM2, gross.touchedM2, gross.easedM2}) csv.number(m2, 1);
    csv.number(gross.meanMin, 3).number(gross.mostGainedMin, 2).number(gross.mostLostMin, 2);
    if (std::isnan(runs.meanMin))  // the measure was not computed
        csv.nothing(2);
    else
        csv.number(runs.gainedM2, 1).number(runs.lostM2, 1);
    csv.number(figures.shadowAreaChangeM2, 1);
    csv.number(figures.becameBuildingM2, 1).number(figures.becameGroundM2, 1);
    addSource(csv, source);
    csv.endRow();
}

std::vector<RepeatOption> optionsOf(const ImpactAnswer& answer) {
    RepeatOption thresholds{"--threshold", {}};
    for (const double threshold : answer.thresholdsMin)
        thresholds.values.push_back(fmt::format("{}", threshold));
    std::vector<RepeatOption> options{{"--from", {answer.from}}, {"--to", {answer.to}}, thresholds};
    if (answer.settings.byBuilding) options.push_back({"--by-building", {}});
    addErrorSample(answer.settings.study.errorSample, options);
    return options;
}

}  // namespace

ComparisonFigures computeFigures(const ImpactAnswer& answer) {
    const Impact& total = answer.study.total;
    ComparisonFigures figures{answer.from,  answer.to,    {}, {}, formatText(answer.settings.study.period),
                              total.engine, total.waterM2};
    for (const double threshold : answer.thresholdsMin)
        figures.all.push_back(computeFigures(total, threshold));
    for (const BuildingImpact& building : answer.study.byBuilding)
        figures.byBuilding.push_back({building.name.empty() ? building.id : building.name,
                                      computeFigures(building.impact, answer.thresholdsMin.front())});
    return figures;
}

Result<std::string> makeRepeatCommand(const ImpactAnswer& answer, std::size_t width) {
    return makeRepeatCommand(projectQuestion("impact", answer.settings.study, answer.provenance,
                                             answer.study.after.engineKey, optionsOf(answer)),
                             width);
}

std::string impactJson(const ImpactAnswer& answer) {
    const Impact& total = answer.study.total;
    Json json = settingsJson(answer.settings.study);
    json["from"] = answer.from;
    json["to"] = answer.to;
    json["engine_settings"] = total.engine;
    json["steps"] = answer.study.sun.steps.size();
    json["period"]["counted_step_min"] = total.stepMinutes;
    json["sunlit_min_per_day"] = total.sunlitMinutesPerDay;
    json["water_m2"] = total.waterM2;
    json["error"] = answer.study.error ? errorJson(*answer.study.error, answer.study.frame) : Json();
    json["impact"] = figuresJson(total, answer.thresholdsMin);
    json["by_building"] = Json::array();
    for (const BuildingImpact& building : answer.study.byBuilding)
        json["by_building"].push_back({{"id", building.id},
                                       {"name", building.name},
                                       {"impact", figuresJson(building.impact, answer.thresholdsMin)}});
    addProvenance(json, answer.provenance);
    addRepeat(json, makeRepeatCommand(answer, std::numeric_limits<std::size_t>::max()));
    json["definitions"] = definitions();
    json["warnings"] = warningsJson(total.warnings);
    return toJsonText(json);
}

std::string impactCsv(const ImpactAnswer& answer) {
    CsvText csv(withSourceColumns({"id", "name", "threshold_min", "gained_m2", "lost_m2", "touched_m2",
                                   "eased_m2", "mean_min", "most_gained_min", "most_lost_min",
                                   "continuous_gained_m2", "continuous_lost_m2", "shadow_area_change_m2",
                                   "became_building_m2", "became_ground_m2"}));
    const SourceValues source = sourceValues(answer.provenance);
    for (const double threshold : answer.thresholdsMin)
        addLine(csv, "", "all", computeFigures(answer.study.total, threshold), source);
    for (const BuildingImpact& building : answer.study.byBuilding)
        for (const double threshold : answer.thresholdsMin)
            addLine(csv, building.id, building.name, computeFigures(building.impact, threshold), source);
    return csv.take();
}

}  // namespace noonmark
