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
/// score the weight table (kept_answer.h reads it back). Costs a hash of each city.
KeptResult keptResult(const Project& project, const std::string& scenario, const Study& study,
                      std::chrono::sys_seconds at = timeNow());
KeptResult keptResult(const Project& project, const ImpactAnswer& answer,
                      std::chrono::sys_seconds at = timeNow());
KeptResult keptResult(const Project& project, const ScoreAnswer& answer,
                      std::chrono::sys_seconds at = timeNow());

/// The project with a result in it; one of the same name is replaced.
Project withResult(Project project, KeptResult result);

/// Both in one.
Project withResult(Project project, const std::string& name, const std::string& scenario, const Study& study,
                   std::chrono::sys_seconds at = timeNow());
Project withResult(Project project, const std::string& name, const ImpactAnswer& answer,
                   std::chrono::sys_seconds at = timeNow());
Project withResult(Project project, const std::string& name, const ScoreAnswer& answer,
                   std::chrono::sys_seconds at = timeNow());

}  // namespace noonmark
