#pragma once

#include <chrono>

#include "scenarios/impact/impact_text.h"
#include "scenarios/project/project.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

inline std::chrono::sys_seconds timeNow() {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

/// A result to be kept, without a name yet. `scenario`: whose city the study is of. Beside the answer's own
/// JSON its settings hold an object `kept`: when, the hashes of the cities that the answer is of, and of a
/// score the weight table (saved_answer.h reads it back). Costs a hash of each city.
SavedResult makeSavedResult(const Project& project, const std::string& scenario, const Study& study,
                            std::chrono::sys_seconds at = timeNow());
SavedResult makeSavedResult(const Project& project, const ImpactAnswer& answer,
                            std::chrono::sys_seconds at = timeNow());
SavedResult makeSavedResult(const Project& project, const ScoreAnswer& answer,
                            std::chrono::sys_seconds at = timeNow());

/// The project with a result in it; one of the same name is replaced.
Project addResult(Project project, SavedResult result);

/// Both in one.
Project addResult(Project project, const std::string& name, const std::string& scenario, const Study& study,
                  std::chrono::sys_seconds at = timeNow());
Project addResult(Project project, const std::string& name, const ImpactAnswer& answer,
                  std::chrono::sys_seconds at = timeNow());
Project addResult(Project project, const std::string& name, const ScoreAnswer& answer,
                  std::chrono::sys_seconds at = timeNow());

}  // namespace noonmark
