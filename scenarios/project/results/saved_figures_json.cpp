#include "scenarios/project/results/saved_figures_json.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/base/json_number.h"
#include "core/base/safe_text.h"
#include "core/describe/figure_text.h"
#include "core/measures/shadow_figures.h"
#include "core/sun/civil_time.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* building = "building";
constexpr const char* ground = "ground";

CellChange changeNamed(const Json& json) {
    if (json == building) return CellChange::becameBuilding;
    if (json == ground) return CellChange::becameGround;
    throw std::invalid_argument("a changed cell is of an unknown kind");
}

}  // namespace

Json changedCellsJson(const std::vector<CellChange>& change) {
    Json json = Json::array();
    for (std::size_t first = 0, end = 0; first < change.size(); first = end) {
        for (end = first + 1; end < change.size() && change[end] == change[first];) ++end;
        if (change[first] == CellChange::none) continue;
        json.push_back({first, end - first, change[first] == CellChange::becameBuilding ? building : ground});
    }
    return json;
}

std::vector<CellChange> parseChangedCells(const Json& json, std::size_t cells) {
    std::vector<CellChange> change(cells, CellChange::none);
    for (const Json& run : json) {
        const auto first = wholeNumberFrom<std::size_t>(run.at(0)),
                   count = wholeNumberFrom<std::size_t>(run.at(1));
        if (first > cells || count > cells - first)
            throw std::invalid_argument("changed cells lie outside the grid");
        std::fill_n(change.begin() + std::ptrdiff_t(first), count, changeNamed(run.at(2)));
    }
    return change;
}

namespace {

// null: not computed.
ChangeFigures changeFrom(const Json& json) {
    return json.is_null() ? notComputed() : readFigures(changeFigures(), json);
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

std::vector<ShownError> savedErrors(const Json& result) {
    return parseErrors(result.value("errors", Json()));
}

ImpactFigures parseImpactFigures(const Json& json) {
    ImpactFigures figures = readFigures(impactFigures(), json);
    figures.gross = changeFrom(json.at("gross"));
    figures.continuous = changeFrom(json.at("continuous"));
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (const std::string suffix = suffixOf(column); json.contains("gross" + suffix))
            figures.withTrees.push_back({column, changeFrom(json.at("gross" + suffix)),
                                         changeFrom(json.at("continuous" + suffix)),
                                         json.at("shadow_area_change_m2" + suffix).get<double>()});
    return figures;
}

ShadowStatistics parseStatistics(const Json& study) { return readFigures(shadowFigures(), study); }

ComparisonFigures parseComparison(const Json& impact) {
    ComparisonFigures figures{
        impact.at("from"),           impact.at("to"), {}, {}, readStatedPeriod(impact.at("period")),
        impact.at("engine_settings")};
    figures.waterM2 = impact.value("water_m2", 0.0);
    figures.errors = savedErrors(impact);
    for (const Json& one : impact.at("impact")) figures.all.push_back(parseImpactFigures(one));
    if (figures.all.empty()) throw std::invalid_argument("no figures");
    for (const Json& building : impact.at("by_building"))
        figures.byBuilding.push_back({nameOrId(building), parseImpactFigures(building.at("impact").at(0))});
    return figures;
}

std::vector<MonthFigures> parseScoreMonths(const Json& months) {
    std::vector<MonthFigures> parsed;
    for (const Json& month : months) {
        MonthFigures& figures = parsed.emplace_back(readFigures(scoreMonthFigures(), month));
        figures.month = monthFrom(month.at("month"));
    }
    return parsed;
}

namespace {

// What trees do not change of months and intervals is that of the score without them.
ShadedScore shadedScore(const Json& json, TreeColumns column, const Score& without) {
    ShadedScore with{without, column, {}, without.months, without.intervals};
    readRows<ScoreTotals>(scoreFiguresWithTrees(column), json, with);
    for (std::size_t i = 0; i < with.months.size(); ++i)
        readRows(scoreMonthFiguresWithTrees(column), json.at("months").at(i), with.months[i]);
    for (std::size_t i = 0; i < with.intervals.size(); ++i)
        readRows(scoreIntervalFiguresWithTrees(column), json.at("intervals").at(i), with.intervals[i]);
    return with;
}

}  // namespace

std::vector<ShadedScore> parseShadedScores(const Json& json, const Score& without) {
    std::vector<ShadedScore> all;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (json.contains(scoreFiguresWithTrees(column).front().key))
            all.push_back(shadedScore(json, column, without));
    return all;
}

Score parseScore(const Json& json) {
    Score score;
    static_cast<ScoreTotals&>(score) = readFigures(scoreFigures(), json);
    score.months = parseScoreMonths(json.at("months"));
    for (const Json& interval : json.at("intervals")) {
        IntervalFigures& figures =
            score.intervals.emplace_back(readFigures(scoreIntervalFigures(), interval));
        figures.name = interval.at("name");
    }
    score.withTrees = parseShadedScores(json, score);
    score.treesHow = json.value("engine_trees", std::string());
    score.engine = json.at("engine_settings");
    score.errors = savedErrors(json);
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
    return fmt::format("area {} % of the ground; {}{}; {} of {} against the ray reference",
                       formatSigned(error.at("area_pct").get<double>(), 4),
                       describeSavedCell("gross", error.at("gross")),
                       runs.is_object() ? "; " + describeSavedCell("continuous", runs) : std::string(),
                       wholeNumberFrom<std::uint64_t>(error.at("sample_receivers")),
                       countOf(wholeNumberFrom<std::uint64_t>(error.at("of_receivers")), "receiver"));
}

}  // namespace noonmark
