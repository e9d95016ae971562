#include "scenarios/project/keep_result.h"

#include <fmt/chrono.h>

#include "core/study/inputs_json.h"
#include "core/study/study_hash.h"
#include "core/study/warnings_json.h"
#include "scenarios/settings_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

std::string hashOf(const Project& project, const std::string& scenario) {
    const auto city = cityOf(project, scenario);
    return city ? cityHash(city->city) : std::string();
}

std::string textOf(std::chrono::sys_seconds at) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(at)));
}

std::string withOrigin(const std::string& settings, std::chrono::sys_seconds at, const std::string& cityHash,
                       const std::string& baselineHash) {
    Json json = Json::parse(settings);
    Json kept{{"at", textOf(at)}, {"city_sha256", cityHash}};
    if (!baselineHash.empty()) kept["baseline_sha256"] = baselineHash;
    json["kept"] = std::move(kept);
    return jsonText(json);
}

Project with(Project project, KeptResult result) {
    result.inputs = inputsJson(project.inputs).dump();
    std::erase_if(project.results, [&](const auto& old) { return old->name == result.name; });
    project.results.push_back(std::make_shared<const KeptResult>(std::move(result)));
    return project;
}

}  // namespace

Project withResult(Project project, const std::string& name, const std::string& scenario, const Study& study,
                   std::chrono::sys_seconds at) {
    const ShadowField& field = study.field;
    return with(std::move(project), {name,
                                     "study",
                                     scenario,
                                     {},
                                     withOrigin(studyJson(study), at, cityHash(study.city), {}),
                                     {},
                                     field.grid,
                                     {{"gross shadow", "min/day", field.grossMin},
                                      {"continuous shadow", "min", field.continuousMin}}});
}

Project withResult(Project project, const std::string& name, const ImpactAnswer& answer,
                   std::chrono::sys_seconds at) {
    const Impact& impact = answer.study.total;
    const std::string settings =
        withOrigin(impactJson(answer), at, hashOf(project, answer.to), hashOf(project, answer.from));
    return with(std::move(project), {name,
                                     "impact",
                                     answer.to,
                                     answer.from,
                                     settings,
                                     {},
                                     impact.grid,
                                     {{"change of gross shadow", "min/day", impact.grossMin},
                                      {"change of continuous shadow", "min", impact.continuousMin}}});
}

Project withResult(Project project, const std::string& name, const ScoreAnswer& answer,
                   std::chrono::sys_seconds at) {
    const std::string settings = withOrigin(scoreJson(answer), at, hashOf(project, answer.scenario), {});
    return with(std::move(project), {name,
                                     "score",
                                     answer.scenario,
                                     {},
                                     settings,
                                     {},
                                     answer.score.grid,
                                     {{"shadow score", "", answer.score.score}}});
}

}  // namespace noonmark
