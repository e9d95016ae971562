#pragma once

#include "app/cli/command.h"

namespace noonmark::cli {

// The commands of `project`, each in a file of its name.
void addProjectNew(CLI::App& project, Run& run);
void addProjectInfo(CLI::App& project, Run& run);
void addProjectAddScenario(CLI::App& project, Run& run);
void addProjectDemolish(CLI::App& project, Run& run);
void addProjectExtrude(CLI::App& project, Run& run);
void addProjectVariant(CLI::App& project, Run& run);
void addProjectExport(CLI::App& project, Run& run);

}  // namespace noonmark::cli
