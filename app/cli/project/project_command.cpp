#include "app/cli/project/project_commands.h"

namespace noonmark::cli {

void addProjectCommand(CLI::App& app, Run& run) {
    CLI::App* project = app.add_subcommand(
        "project",
        "Create and change a project: a city with its scenarios, lots, regions and places in one file");
    project->require_subcommand(1);
    addProjectNew(*project, run);
    addProjectInfo(*project, run);
    addProjectScenarios(*project, run);
    addProjectDemolish(*project, run);
    addProjectReplace(*project, run);
    addProjectHeight(*project, run);
    addProjectMove(*project, run);
    addProjectRotate(*project, run);
    addProjectImport(*project, run);
    addProjectExtrude(*project, run);
    addProjectVariant(*project, run);
    addProjectLot(*project, run);
    addProjectRegion(*project, run);
    addProjectPlace(*project, run);
    addProjectPeriod(*project, run);
    addProjectContext(*project, run);
    addProjectPhotograph(*project, run);
    addProjectWeights(*project, run);
    addProjectSheets(*project, run);
    addProjectResult(*project, run);
    addProjectExport(*project, run);
    addProjectShadows(*project, run);
    addProjectAnimate(*project, run);
    project->footer(
        "A first project:\n"
        "  noonmark-cli project new park.noonmark.gpkg sample:central-park-south\n"
        "  noonmark-cli project add-scenario park.noonmark.gpkg \"Without One57\"\n"
        "  noonmark-cli project demolish park.noonmark.gpkg One57 --scenario \"Without One57\"\n"
        "  noonmark-cli impact park.noonmark.gpkg --from \"Without One57\" --to Existing --region Park \\\n"
        "    --start 2026-11-01 --days 61 --at 08:00 --hours 8 --zone America/New_York --out out");
}

}  // namespace noonmark::cli
