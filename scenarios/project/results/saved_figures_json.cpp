#include "scenarios/project/results/saved_figures_json.h"

#include <fmt/format.h>

#include <limits>

#include "core/base/json_number.h"
#include "core/sun/civil_time.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// null: not computed.
double minutesFrom(const Json& json) { return json.is_null() ? unknown : json.get<double>(); }

ChangeFigures changeFrom(const Json& json) {
    if (json.is_null()) return {unknown, unknown, unknown, unknown, unknown, unknown, unknown};
    return {json.at("gained_m2"), json.at("lost_m2"),         json.at("touched_m2"),   json.at("eased_m2"),
            json.at("mean_min"),  json.at("most_gained_min"), json.at("most_lost_min")};
}

std::chrono::year_month monthFrom(const std::string& text) {
    const auto first = parseDate(text + "-01");
    if (!first) throw std::invalid_argument(text + " is not a month");
    return first->year() / first->month();
}

std::string nameOrId(const Json& building) {
    const std::string name = building.at("name");
    return name.empty() ? building.at("id").get<std::string>() : name;
}

}  // namespace

ImpactFigures parseImpactFigures(const Json& json) {
    return {json.at("threshold_min"),         json.at("receiver_area_m2"),
            changeFrom(json.at("gross")),     changeFrom(json.at("continuous")),
            json.at("shadow_area_change_m2"), json.at("became_building_m2"),
            json.at("became_ground_m2")};
}

ShadowStatistics parseStatistics(const Json& study) {
    return {wholeNumberFrom<std::size_t>(study.at("receivers")),
            study.at("receiver_area_m2"),
            study.at("shadow_area_m2"),
            study.at("mean_gross_min"),
            study.at("max_gross_min"),
            minutesFrom(study.at("mean_continuous_min")),
            minutesFrom(study.at("max_continuous_min")),
            study.value("water_m2", 0.0)};
}

ComparisonFigures parseComparison(const Json& impact) {
    ComparisonFigures figures{
        impact.at("from"),           impact.at("to"), {}, {}, impact.at("period").at("text"),
        impact.at("engine_settings")};
    figures.waterM2 = impact.value("water_m2", 0.0);
    for (const Json& one : impact.at("impact")) figures.all.push_back(parseImpactFigures(one));
    if (figures.all.empty()) throw std::invalid_argument("no figures");
    for (const Json& building : impact.at("by_building"))
        figures.byBuilding.push_back({nameOrId(building), parseImpactFigures(building.at("impact").at(0))});
    return figures;
}

Score parseScore(const Json& json) {
    Score score;
    score.scoreM2 = json.at("score_m2");
    score.weightedShadeM2h = json.value("weighted_shade_m2h", unknown);
    score.receiverAreaM2 = json.at("receiver_area_m2");
    score.waterM2 = json.value("water_m2", 0.0);
    for (const Json& month : json.at("months"))
        score.months.push_back({monthFrom(month.at("month")), month.at("shadow_area_m2"),
                                month.at("score_m2"), month.at("sunlit_min"),
                                month.value("weighted_shade_m2h", unknown)});
    for (const Json& interval : json.at("intervals"))
        score.intervals.push_back({interval.at("name"), interval.at("weight"), interval.at("shadow_area_m2"),
                                   interval.at("score_m2"), interval.value("weighted_shade_m2h", unknown)});
    score.engine = json.at("engine_settings");
    return score;
}

namespace {

// Results of early versions state no 99th percentile.
std::string describeSavedCell(const char* name, const Json& error) {
    const std::string tail = error.contains("p99_pct") ? fmt::format("99 % of cells within {:.3f} %, ",
                                                                     error.at("p99_pct").get<double>())
                                                       : std::string();
    return fmt::format("{}, mean {:.4f} %, {}worst cell {:.3f} %", name, error.at("mean_pct").get<double>(),
                       tail, error.at("max_pct").get<double>());
}

}  // namespace

std::string parseErrorText(const Json& study) {
    const Json& error = study.at("error");
    if (!error.at("why_not").is_null()) return error.at("why_not");
    const Json runs = error.value("continuous", Json());
    return fmt::format("area {:+.4f} % of the ground; {}{}; {} of {} receivers against the ray reference",
                       error.at("area_pct").get<double>(), describeSavedCell("gross", error.at("gross")),
                       runs.is_object() ? "; " + describeSavedCell("continuous", runs) : std::string(),
                       wholeNumberFrom<std::uint64_t>(error.at("sample_receivers")),
                       wholeNumberFrom<std::uint64_t>(error.at("of_receivers")));
}

}  // namespace noonmark
