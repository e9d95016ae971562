#pragma once

#include <cstddef>
#include <string>

#include "scenarios/project/project.h"

namespace noonmark {

/// What a project is made of, as lists show it.
enum class ProjectPart { lot, region, scenario, weights, period, result };

/// "Proposal A", "Proposal B"... "Proposal Z", "Proposal 27": the first that no scenario bears.
std::string nextProposal(const std::vector<Scenario>& scenarios);

/// The name, or "name (2)", "name (3)"...: the first that no part of this kind bears.
std::string freeName(const Project& project, ProjectPart part, const std::string& name);

/// Changes of a project, as new values. Whether the outcome is sound is for ProjectSession::change() to say.
Project withScenario(Project project, const std::string& name, const std::string& base);
/// Error: no scenario may have this name.
Result<Project> renameIn(Project project, ProjectPart part, const std::string& from, const std::string& to);
/// Error: the scenario is one that others start from.
Result<Project> without(Project project, ProjectPart part, const std::string& name);
/// A copy under a free name, after the original; `made` gets the name.
Project duplicate(Project project, ProjectPart part, const std::string& name, std::string& made);
/// A scenario with another base; empty or "Existing": the existing city.
Project rebase(Project project, const std::string& scenario, const std::string& base);
Project withoutEdit(Project project, const std::string& scenario, std::size_t position);

}  // namespace noonmark
