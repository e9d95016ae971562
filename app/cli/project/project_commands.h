#pragma once

#include "app/cli/command.h"

namespace noonmark::cli {

// The commands of `project`, in files of their names; what edits a scenario has the word of getKind().
void addProjectNew(CLI::App& project, Run& run);
void addProjectInfo(CLI::App& project, Run& run);
void addProjectScenarios(CLI::App& project, Run& run);  // add-scenario and its like
void addProjectDemolish(CLI::App& project, Run& run);
void addProjectReplace(CLI::App& project, Run& run);
void addProjectHeight(CLI::App& project, Run& run);
void addProjectMove(CLI::App& project, Run& run);
void addProjectRotate(CLI::App& project, Run& run);
void addProjectImport(CLI::App& project, Run& run);
void addProjectExtrude(CLI::App& project, Run& run);
void addProjectVariant(CLI::App& project, Run& run);
void addProjectLot(CLI::App& project, Run& run);
void addProjectRegion(CLI::App& project, Run& run);
void addProjectWeights(CLI::App& project, Run& run);
void addProjectPeriod(CLI::App& project, Run& run);
void addProjectResult(CLI::App& project, Run& run);
void addProjectExport(CLI::App& project, Run& run);

}  // namespace noonmark::cli
