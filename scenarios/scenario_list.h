#pragma once

#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace noonmark {

// Changes to a sound list of scenarios; it stays sound, and on an Error as it was. Error: no such scenario,
// the existing city, or a new name that is taken.

/// Those that start from it then start from the new name. Kept results keep the name that they were made of.
Result<void> renameScenario(std::vector<Scenario>& scenarios, const std::string& name,
                            const std::string& newName);

/// A copy with the same base and edits, right after it.
Result<void> duplicateScenario(std::vector<Scenario>& scenarios, const std::string& name,
                               const std::string& newName);

/// Error too where others start from it, with their names.
Result<void> removeScenario(std::vector<Scenario>& scenarios, const std::string& name);

}  // namespace noonmark
