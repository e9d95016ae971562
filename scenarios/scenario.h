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
/// applied().
Result<EditedCity> cityOf(const City& existing, const std::vector<Scenario>& scenarios,
                          const std::string& name);

/// Error: a name is missing, used twice or equal to existingCity, or a base is unknown or part of a cycle.
Result<void> validate(const std::vector<Scenario>& scenarios);

}  // namespace noonmark
