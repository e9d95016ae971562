#include "app/gui/docks/scenarios/latest_answers.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/questions/question.h"
#include "core/describe/figure_text.h"
#include "core/measures/shadow_figures.h"
#include "scenarios/project/results/saved_answer.h"
#include "scenarios/project/results/saved_figures_json.h"
#include "scenarios/settings_json.h"
#include "scenarios/weights/score_text.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

// What settingsJson() states of the question, without what a result adds to it.
Json questionOf(const Json& settings) {
    Json question;
    for (const char* key : {"engine", "region", "cell_m", "receivers_on"})
        question[key] = settings.value(key, Json());
    for (const char* key : {"start", "days", "from", "hours", "window", "step_min", "zone", "refraction"})
        question["period"][key] = settings.at("period").value(key, Json());
    return question;
}

// Of results that state no hash of it.
bool haveOldSettings(const SavedFigures& saved, const StudySettings& settings) {
    if (saved.settings.empty()) return false;
    const auto grid = gridOver(settings.region, settings.receivers);
    return grid && *grid == saved.grid && Json::parse(saved.settings) == questionOf(settingsJson(settings));
}

Json sunJson(const ScenarioSun& sun) {
    Json json{{"places", sun.places}, {"enough_hours", sun.enoughHours}};
    json.update(figuresJson(sunOfPlaceFigures().of(sun.mean)));
    for (std::size_t i = 0; i < sun.months.size(); ++i)
        json["months"][sun.months[i]] = sun.mean.monthHours[i];
    return json;
}

ScenarioSun sunFrom(const Json& json) {
    ScenarioSun sun{json.at("places"), json.at("enough_hours"), {}, readFigures(sunOfPlaceFigures(), json)};
    const Json months = json.value("months", Json::object());
    for (const auto& [month, hours] : months.items()) {
        if (!monthOfKey(month).ok()) throw std::invalid_argument("not a month");
        sun.months.push_back(month);
        sun.mean.monthHours.push_back(hours.is_null() ? SunOfPlace::none : hours.get<double>());
    }
    return sun;
}

Json viewJson(const ViewFigures& saved) {
    const SavedFigures& figures = saved.figures;
    Json json{{"city_sha256", saved.citySha256}, {"question_sha256", figures.question}};
    if (!saved.baselineSha256.empty()) json["baseline_sha256"] = saved.baselineSha256;
    if (figures.measured) json["measured"] = figuresJson(shadowFigures().of(*figures.measured));
    if (figures.impact) json["impact"] = figuresJson(*figures.impact);
    if (figures.sun) json["sun"] = sunJson(*figures.sun);
    if (!figures.weights) return json;
    json["score"] = {{"table", figures.weights->name},
                     {"weights", Json::parse(weightsJson(*figures.weights))}};
    json["score"].update(figuresJson(scoreFigures().of(figures.score)));
    for (const ShadedScore& with : figures.scoreWithTrees)
        json["score"].update(
            figuresJson({scoreFiguresWithTrees(with.column), static_cast<const ScoreTotals*>(&with)}));
    json["score"]["months"] = monthsJson(figures.scoreMonths, figures.scoreWithTrees);
    json["score"]["errors"] = errorsJson(figures.scoreErrors);
    return json;
}

TimeWeights weightsFrom(const Json& score) {
    auto table = parseWeightsJson(score.at("weights").dump(), score.at("table").get<std::string>());
    if (!table) throw std::invalid_argument(table.error().what);
    return *std::move(table);
}

std::optional<ViewFigures> viewFiguresFrom(const Json& json) try {
    ViewFigures saved{json.at("city_sha256"), json.value("baseline_sha256", ""), {}};
    SavedFigures& figures = saved.figures;
    figures.question = json.at("question_sha256");
    if (json.contains("measured")) figures.measured = parseStatistics(json.at("measured"));
    if (json.contains("impact")) figures.impact = parseImpactFigures(json.at("impact"));
    if (json.contains("sun")) figures.sun = sunFrom(json.at("sun"));
    if (json.contains("score")) {
        figures.weights = weightsFrom(json.at("score"));
        figures.score = readFigures(scoreFigures(), json.at("score"));
        figures.scoreMonths = parseScoreMonths(json.at("score").value("months", Json::array()));
        figures.scoreErrors = parseErrors(json.at("score").value("errors", Json::array()));
        Score without;
        static_cast<ScoreTotals&>(without) = figures.score;
        without.months = figures.scoreMonths;
        figures.scoreWithTrees = parseShadedScores(json.at("score"), without);
    }
    return saved;
} catch (const std::exception&) {  // JSON of another shape
    return std::nullopt;
}

void take(const SavedStudy& study, SavedFigures& figures) { figures.measured = study.statistics; }

void take(const SavedScore& score, SavedFigures& figures) {
    figures.score = score.score;
    figures.scoreMonths = score.score.months;
    figures.scoreErrors = score.score.errors;
    figures.scoreWithTrees = score.score.withTrees;
}

void take(const SavedImpact& impact, SavedFigures& figures) { figures.impact = impact.figures.all.front(); }

/// A kind of results with figures of a scenario, and how they are taken from what was saved.
struct FiguresOfKind {
    std::string_view kind;
    void (*takeFrom)(const std::any& content, SavedFigures& figures);
};

template <class T>
FiguresOfKind figuresOf(const Question& question) {
    return {question.key, [](const std::any& content, SavedFigures& figures) {
                take(std::any_cast<const T&>(content), figures);
            }};
}

const FiguresOfKind* findFiguresOf(std::string_view kind) {
    static const std::array all{figuresOf<SavedStudy>(studyQuestion()),
                                figuresOf<SavedScore>(scoreQuestion()),
                                figuresOf<SavedImpact>(comparisonQuestion())};
    const auto found = std::ranges::find(all, kind, &FiguresOfKind::kind);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::optional<SavedFigures> readSavedFigures(const SavedResult& result, const Project& project) {
    const FiguresOfKind* const of = findFiguresOf(result.kind);
    if (of == nullptr) return std::nullopt;
    const auto saved = readSavedAnswer(result);
    if (!saved || !findChangesSince(result, saved->origin, project).empty()) return std::nullopt;
    SavedFigures figures{.question = saved->origin.questionSha256, .weights = saved->origin.weights};
    figures.grid = result.grid;
    of->takeFrom(saved->content, figures);
    if (!figures.measured) figures.settings = questionOf(Json::parse(result.settings)).dump();
    return figures;
}

bool haveSettings(const SavedFigures& saved, const StudySettings& settings, const QuestionHashes& hashes) {
    return saved.question.empty() ? haveOldSettings(saved, settings) : hashes.matches(saved.question);
}

std::string formatText(const std::vector<ViewFigures>& saved) {
    Json json = Json::array();
    for (const ViewFigures& one : saved) json.push_back(viewJson(one));
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<ViewFigures> parseViewFigures(const std::string& text) {
    constexpr std::size_t maximum = 1000;  // far more than the window keeps
    std::vector<ViewFigures> saved;
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_array() || json.size() > maximum) return saved;
    for (const Json& one : json)
        if (auto figures = viewFiguresFrom(one)) saved.push_back(*std::move(figures));
    return saved;
}

}  // namespace noonmark
