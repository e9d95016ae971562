#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// The city as it stands: what a scenario without a base starts from. No scenario bears this name.
inline constexpr const char* existingCity = "Existing";

/// Limits that no work reaches: a file that goes beyond was made to stop the program.
inline constexpr std::size_t mostBases = 100;        ///< from one scenario down to the existing city
inline constexpr std::size_t mostScenarios = 10000;  ///< of a project

/// A named list of edits to the existing city, or to what another scenario makes of it.
struct Scenario {
    std::string name;         ///< unique in a project, not empty
    std::string base;         ///< the scenario it starts from; empty: the existing city
    std::vector<Edit> edits;  ///< in the order in which they are made
    bool operator==(const Scenario&) const = default;
};

/// The scenario of a name; nullptr where there is none.
const Scenario* findScenario(const std::vector<Scenario>& scenarios, const std::string& name);

/// All edits that lead from the existing city to a scenario, its bases' first. Empty for existingCity.
/// Error: an unknown name, or scenarios that start from one another in a circle.
Result<std::vector<Edit>> collectEdits(const std::vector<Scenario>& scenarios, const std::string& name);

/// What a scenario makes of the existing city, and what it changes in it. Errors as of editsOf and applied().
Result<EditedCity> cityOf(const City& existing, const std::vector<Scenario>& scenarios,
                          const std::string& name);

/// Error where names are missing, double or existingCity, or bases are unknown or circular.
Result<void> checked(const std::vector<Scenario>& scenarios);

}  // namespace noonmark
