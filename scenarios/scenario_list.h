#pragma once

#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace noonmark {

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

}  // namespace noonmark
