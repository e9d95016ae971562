#include "scenarios/weights/score_text.h"

#include <fmt/format.h>

#include <limits>

#include "core/describe/command_flags.h"
#include "core/describe/figure_text.h"
#include "core/study/provenance/provenance_json.h"
#include "core/study/provenance/source_columns.h"
#include "core/study/text/warnings_json.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

std::string formatText(std::chrono::year_month month) {
    return fmt::format("{:04}-{:02}", int(month.year()), unsigned(month.month()));
}

// Each with its name first.
template <class R, class Name>
Json listJson(const std::vector<R>& list, const char* key, Name nameOf, const Figures<R>& figures) {
    Json json = Json::array();
    for (const R& one : list) {
        Json& object = json.emplace_back(Json{{key, nameOf(one)}});
        object.update(figuresJson(figures.of(one)));
    }
    return json;
}

std::string monthOf(const MonthFigures& month) { return formatText(month.month); }

}  // namespace

Result<std::string> makeRepeatCommand(const ScoreAnswer& answer, std::size_t width) {
    return makeRepeatCommand(
        projectQuestion("score", answer.settings, answer.provenance, answer.score.engineKey,
                        {{flags::weights, {answer.weights.name}}}),
        width);
}

Json monthsJson(const std::vector<MonthFigures>& months) {
    return listJson(months, "month", &monthOf, scoreMonthFigures());
}

std::string scoreJson(const ScoreAnswer& answer) {
    Json json = settingsJson(answer.settings);
    addProvenance(json, answer.provenance);
    addRepeat(json, makeRepeatCommand(answer, std::numeric_limits<std::size_t>::max()));
    json["scenario"] = answer.scenario;
    json["weights"] = answer.weights.name;
    json["engine_settings"] = answer.score.engine;
    json.update(figuresJson(scoreFigures().of(answer.score)));
    json["errors"] = errorsJson(answer.score.errors);
    json["months"] = monthsJson(answer.score.months);
    json["intervals"] = listJson(
        answer.score.intervals, "name", [](const IntervalFigures& interval) { return interval.name; },
        scoreIntervalFigures());
    json["definitions"] = definitionsJson(scoreMonthFigures().rows());
    json["warnings"] = warningsJson(answer.score.warnings);
    return toJsonText(json);
}

std::string scoreCsv(const ScoreAnswer& answer) {
    std::vector<std::string> columns = listColumns(scoreMonthFigures().rows());
    columns.insert(columns.begin(), "month");
    CsvText csv(withSourceColumns(std::move(columns)));
    const SourceValues source = sourceValues(answer.provenance);
    for (const MonthFigures& month : answer.score.months) {
        csv.text(monthOf(month));
        addFigures(csv, scoreMonthFigures().of(month));
        addSource(csv, source);
        csv.endRow();
    }
    return csv.take();
}

}  // namespace noonmark
