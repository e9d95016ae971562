#pragma once

// The folder app/report/scenarios puts the same study of several scenarios side by side: scenario_text.h as
// tables for programs, scenario_book.h as sheets, and scenario_files.h as the complete set of files.

#include <memory>
#include <string>
#include <vector>

#include "core/study/study.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

/// A scenario with its study. Those that are put side by side have the same settings, so that their figures
/// can be compared; the first is what the others are compared with.
struct ScenarioStudy {
    std::string name;
    std::shared_ptr<const Study> study;  ///< not null; states its provenance
    ScenarioUses uses{};                 ///< of its towers
};
using ScenarioStudies = std::vector<ScenarioStudy>;

/// Steps from the existing city to the scenario, including those of its bases.
std::size_t countChanges(const ScenarioStudy& scenario);

/// Shadow area of the scenario minus that of the first, m2.
double computeShadowAreaChange(const ScenarioStudies& scenarios, const ScenarioStudy& scenario);

}  // namespace noonmark
