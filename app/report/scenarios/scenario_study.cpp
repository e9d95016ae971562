#include "app/report/scenarios/scenario_study.h"

namespace noonmark {

std::size_t countChanges(const ScenarioStudy& scenario) {
    const auto& project = scenario.study->provenance.project;
    return project ? project->scenario.edits.size() : 0;
}

double computeShadowAreaChange(const ScenarioStudies& scenarios, const ScenarioStudy& scenario) {
    return scenario.study->statistics.shadowAreaM2 - scenarios.front().study->statistics.shadowAreaM2;
}

}  // namespace noonmark
