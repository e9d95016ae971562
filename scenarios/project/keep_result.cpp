#include "scenarios/project/keep_result.h"

#include "core/study/inputs_json.h"
#include "scenarios/settings_json.h"

namespace noonmark {

namespace {

Project with(Project project, KeptResult result) {
    result.inputs = inputsJson(project.inputs).dump();
    std::erase_if(project.results, [&](const auto& old) { return old->name == result.name; });
    project.results.push_back(std::make_shared<const KeptResult>(std::move(result)));
    return project;
}

}  // namespace

Project withResult(Project project, const std::string& name, const std::string& scenario,
                   const Study& study) {
    const ShadowField& field = study.field;
    return with(std::move(project), {name,
                                     "study",
                                     scenario,
                                     {},
                                     studyJson(study),
                                     {},
                                     field.grid,
                                     {{"gross shadow", "min/day", field.grossMin},
                                      {"continuous shadow", "min", field.continuousMin}}});
}

Project withResult(Project project, const std::string& name, const ImpactAnswer& answer) {
    const Impact& impact = answer.study.total;
    return with(std::move(project), {name,
                                     "impact",
                                     answer.to,
                                     answer.from,
                                     impactJson(answer),
                                     {},
                                     impact.grid,
                                     {{"change of gross shadow", "min/day", impact.grossMin},
                                      {"change of continuous shadow", "min", impact.continuousMin}}});
}

Project withResult(Project project, const std::string& name, const ScoreAnswer& answer) {
    return with(std::move(project), {name,
                                     "score",
                                     answer.scenario,
                                     {},
                                     scoreJson(answer),
                                     {},
                                     answer.score.grid,
                                     {{"shadow score", "", answer.score.score}}});
}

}  // namespace noonmark
