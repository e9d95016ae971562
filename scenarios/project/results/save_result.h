#pragma once

// The folder scenarios/project/results/ converts results for the project. This file makes a SavedResult from
// a computed answer (save_result.cpp writes it into the tables); saved_answer.h turns it back into figures
// and maps, and saved_figures_json.h parses its JSON.

#include <chrono>
#include <nlohmann/json_fwd.hpp>

#include "core/study/by_place/sun_by_place.h"
#include "core/study/elements/element_map.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/project/project.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

inline std::chrono::sys_seconds timeNow() {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

/// Makes a saved result without a name. `scenario`: the one whose city was measured. Its settings are the
/// JSON of the answer plus an object `kept`: time, hashes of the measured cities, and for a score the weight
/// table (saved_answer.h reads it back). Costs a hash of each city.
SavedResult makeSavedResult(const Project& project, const std::string& scenario, const Study& study,
                            std::chrono::sys_seconds at = timeNow());
SavedResult makeSavedResult(const Project& project, const std::string& scenario, const ElementStudy& study,
                            std::chrono::sys_seconds at = timeNow());
SavedResult makeSavedResult(const Project& project, const ImpactAnswer& answer,
                            std::chrono::sys_seconds at = timeNow());
SavedResult makeSavedResult(const Project& project, const ScoreAnswer& answer,
                            std::chrono::sys_seconds at = timeNow());

/// Sun by place: with the outlines of the places in `kept`, and without cells. `sun` is of the project's
/// cities under the names of their scenarios; at most one is compared.
SavedResult makeSavedResult(const Project& project, const SunOfCities& sun,
                            std::chrono::sys_seconds at = timeNow());

/// An answer of figures alone, such as a review. `json`: an object with its figures by key, its engine as
/// `engine_settings`, and the name of its `region`. Empty `baseline`: it compares with none.
SavedResult makeSavedResult(const Project& project, const std::string& kind, const std::string& scenario,
                            const std::string& baseline, nlohmann::ordered_json json,
                            std::chrono::sys_seconds at = timeNow());

/// Adds a result to the project; a result of the same name is replaced.
Project addResult(Project project, SavedResult result);

/// makeSavedResult() and addResult() in one call.
Project addResult(Project project, const std::string& name, const std::string& scenario, const Study& study,
                  std::chrono::sys_seconds at = timeNow());
Project addResult(Project project, const std::string& name, const ImpactAnswer& answer,
                  std::chrono::sys_seconds at = timeNow());
Project addResult(Project project, const std::string& name, const ScoreAnswer& answer,
                  std::chrono::sys_seconds at = timeNow());

}  // namespace noonmark
