#include "app/window/scenarios/saved_figures.h"

#include <nlohmann/json.hpp>

#include "scenarios/project/results/saved_answer.h"
#include "scenarios/settings_json.h"

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

}  // namespace

std::optional<SavedFigures> readSavedFigures(const SavedResult& result, const Project& project) {
    if (result.kind != "score" && result.kind != "impact") return std::nullopt;
    const auto saved = readSavedAnswer(result);
    if (!saved || !findChangesSince(result, saved->origin, project).empty()) return std::nullopt;
    SavedFigures figures{questionOf(Json::parse(result.settings)).dump(), result.grid, saved->origin.weights,
                         0, std::nullopt};
    if (const auto* score = std::get_if<SavedScore>(&saved->answer)) figures.scoreM2 = score->score.scoreM2;
    if (const auto* impact = std::get_if<SavedImpact>(&saved->answer))
        figures.impact = impact->figures.all.front();
    return figures;
}

bool haveSettings(const SavedFigures& saved, const StudySettings& settings) {
    const auto grid = gridOver(settings.region, settings.receivers);
    return grid && *grid == saved.grid && Json::parse(saved.question) == questionOf(settingsJson(settings));
}

}  // namespace noonmark
