#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "app/cli/console.h"
#include "scenarios/project/project.h"

namespace noonmark::cli {

/// The file of a command on a project.
void addProjectFile(CLI::App& command, std::string& file);

/// Opens a project, changes it, saves it, and prints what `change` returns. Nothing is saved on an Error.
int changeProject(const std::string& file, const Console& console,
                  const std::function<Result<std::string>(Project&)>& change);

/// The scenario that a command changes; Error for existingCity or an unknown name.
Result<Scenario*> scenarioToChange(Project& project, const std::string& name);

}  // namespace noonmark::cli
