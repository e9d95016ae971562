#pragma once

// The folder scenarios/ answers "what if": edits/ holds single changes to a city, a scenario (this header) is
// a named list of them, massing/ builds towers on lots, impact/ compares two cities, weights/ scores wanted
// shade against unwanted shadow, and project/ stores all of it in one file. Everything here is a plain value
// without Qt or OpenGL.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// Returns `name`, or else the first of "name (2)", "name (3)"... for which `isTaken` is false.
template <class IsTaken>
std::string findFreeName(const std::string& name, IsTaken&& isTaken) {
    std::string free = name;
    for (int copy = 2; isTaken(free); ++copy) free = name + " (" + std::to_string(copy) + ")";
    return free;
}

/// The name of the city without edits, from which a scenario with an empty base starts. No scenario may have
/// this name.
inline constexpr const char* existingCity = "Existing";

/// Far above any real project. A file that exceeds them was made to stall the program.
inline constexpr std::size_t maxBases = 100;  ///< in the chain from one scenario down to the existing city
inline constexpr std::size_t maxScenarios = 10000;  ///< in a project

/// A named list of edits to the existing city or to the city of another scenario, its base.
struct Scenario {
    std::string name;         ///< unique in a project, not empty
    std::string base;         ///< name of the scenario it starts from; empty: the existing city
    std::vector<Edit> edits;  ///< applied in this order
    bool operator==(const Scenario&) const = default;
};

/// Returns nullptr where no scenario has this name.
const Scenario* findScenario(const std::vector<Scenario>& scenarios, const std::string& name);

/// Returns all edits that lead from the existing city to a scenario, those of its bases first. Empty for
/// existingCity. Error: an unknown name, or scenarios whose bases form a cycle.
Result<std::vector<Edit>> collectEdits(const std::vector<Scenario>& scenarios, const std::string& name);

/// Returns the city of a scenario and how it differs from `existing`. Errors as of collectEdits() and
/// applyEdits().
Result<EditedCity> cityOf(const City& existing, const std::vector<Scenario>& scenarios,
                          const std::string& name);

/// Error: a name is missing, used twice or equal to existingCity, or a base is unknown or part of a cycle.
Result<void> validate(const std::vector<Scenario>& scenarios);

/// The existing city, then the scenarios in their order.
std::vector<std::string> listNames(const std::vector<Scenario>& scenarios);

// Changes to a valid list of scenarios. The list stays valid; on an Error it stays unchanged. Error: there is
// no such scenario, the name is that of the existing city, or the new name is taken.

/// Scenarios based on it refer to the new name afterwards. Saved results keep the old name.
Result<void> renameScenario(std::vector<Scenario>& scenarios, const std::string& name,
                            const std::string& newName);

/// Inserts a copy with the same base and edits right after the original.
Result<void> duplicateScenario(std::vector<Scenario>& scenarios, const std::string& name,
                               const std::string& newName);

/// Error also where other scenarios are based on it; the Error lists their names.
Result<void> removeScenario(std::vector<Scenario>& scenarios, const std::string& name);

/// Puts `edition` in the place of every import of the same building; the edits that follow stay. Returns how
/// many.
std::size_t replaceImports(std::vector<Scenario>& scenarios, const ImportMesh& edition);

}  // namespace noonmark
