#include "scenarios/weights/score_text.h"

#include <fmt/format.h>

#include <limits>

#include "core/study/provenance/provenance_json.h"
#include "core/study/provenance/source_columns.h"
#include "core/study/text/warnings_json.h"
#include "scenarios/settings_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

std::string formatText(std::chrono::year_month month) {
    return fmt::format("{:04}-{:02}", int(month.year()), unsigned(month.month()));
}

Json monthsJson(const Score& score) {
    Json json = Json::array();
    for (const MonthFigures& month : score.months)
        json.push_back({{"month", formatText(month.month)},
                        {"sunlit_min", month.sunlitMinutes},
                        {"weighted_shade_m2h", month.weightedShadeM2h},
                        {"shadow_area_m2", month.shadowAreaM2},
                        {"score_m2", month.scoreM2}});
    return json;
}

Json intervalsJson(const Score& score) {
    Json json = Json::array();
    for (const IntervalFigures& interval : score.intervals)
        json.push_back({{"name", interval.name},
                        {"weight", interval.weight},
                        {"weighted_shade_m2h", interval.weightedShadeM2h},
                        {"shadow_area_m2", interval.shadowAreaM2},
                        {"score_m2", interval.scoreM2}});
    return json;
}

}  // namespace

Result<std::string> makeRepeatCommand(const ScoreAnswer& answer, std::size_t width) {
    return makeRepeatCommand(projectQuestion("score", answer.settings, answer.provenance,
                                             answer.score.engineKey, {{"--weights", {answer.weights.name}}}),
                             width);
}

std::string scoreJson(const ScoreAnswer& answer) {
    Json json = settingsJson(answer.settings);
    addProvenance(json, answer.provenance);
    addRepeat(json, makeRepeatCommand(answer, std::numeric_limits<std::size_t>::max()));
    json["scenario"] = answer.scenario;
    json["weights"] = answer.weights.name;
    json["engine_settings"] = answer.score.engine;
    json["receiver_area_m2"] = answer.score.receiverAreaM2;
    json["water_m2"] = answer.score.waterM2;
    json["weighted_shade_m2h"] = answer.score.weightedShadeM2h;
    json["score_m2"] = answer.score.scoreM2;
    json["months"] = monthsJson(answer.score);
    json["intervals"] = intervalsJson(answer.score);
    json["definitions"] = {
        {"weighted_shade_m2h", weightedShadeDefinition},
        {"score_m2", scoreDefinition},
        {"shadow_area_m2", "sum over receivers of (share of the sunlit time in shadow x cell area)"}};
    json["warnings"] = warningsJson(answer.score.warnings);
    return toJsonText(json);
}

std::string scoreCsv(const ScoreAnswer& answer) {
    CsvText csv(
        withSourceColumns({"month", "sunlit_min", "weighted_shade_m2h", "shadow_area_m2", "score_m2"}));
    const SourceValues source = sourceValues(answer.provenance);
    for (const MonthFigures& month : answer.score.months) {
        csv.text(formatText(month.month)).number(month.sunlitMinutes, 1);
        csv.number(month.weightedShadeM2h, 1).number(month.shadowAreaM2, 1).number(month.scoreM2, 1);
        addSource(csv, source);
        csv.endRow();
    }
    return csv.take();
}

}  // namespace noonmark
