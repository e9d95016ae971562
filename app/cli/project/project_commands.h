#pragma once

// The folder app/cli/project/ holds the subcommands of `project`, one file each, listed below.
// change_project.h opens and saves the project for commands that change it, edit_scenario.h applies edits to
// a scenario, list_project.h lists and removes entries, and project_options.h parses region and period.

#include "app/cli/base/command.h"

namespace noonmark::cli {

// One file per subcommand of `project`. Commands that make an edit are named as in getKind().
void addProjectNew(CLI::App& project, Run& run);
void addProjectInfo(CLI::App& project, Run& run);
void addProjectScenarios(CLI::App& project, Run& run);  // add-scenario and related commands
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
void addProjectPlace(CLI::App& project, Run& run);
void addProjectTree(CLI::App& project, Run& run);
void addProjectContext(CLI::App& project, Run& run);
void addProjectPhotograph(CLI::App& project, Run& run);
void addProjectWeights(CLI::App& project, Run& run);
void addProjectPeriod(CLI::App& project, Run& run);
void addProjectSheets(CLI::App& project, Run& run);
void addProjectResult(CLI::App& project, Run& run);
void addProjectExport(CLI::App& project, Run& run);
void addProjectAnimate(CLI::App& project, Run& run);
void addProjectShadows(CLI::App& project, Run& run);

}  // namespace noonmark::cli
