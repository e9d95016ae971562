#include "app/report/scenarios/scenario_study.h"

namespace noonmark {

ScenarioStudy makeScenarioStudy(const std::vector<Scenario>& scenarios, std::string name,
                                std::shared_ptr<const Study> study) {
    const std::vector<Edit> edits = collectEdits(scenarios, name).value_or(std::vector<Edit>());
    const auto heightM = findProposedHeightM(study->city, edits);
    return {std::move(name), std::move(study), sumUses(edits), heightM};
}

std::size_t countChanges(const ScenarioStudy& scenario) {
    const auto& project = scenario.study->provenance.project;
    return project ? project->scenario.edits.size() : 0;
}

double computeShadowAreaChange(const ScenarioStudies& scenarios, const ScenarioStudy& scenario) {
    return scenario.study->statistics.shadowAreaM2 - scenarios.front().study->statistics.shadowAreaM2;
}

}  // namespace noonmark
