#include "app/cli/project/change_project.h"

#include <ostream>

#include "app/cli/command.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

void addProjectFile(CLI::App& command, std::string& file) {
    command.add_option("project", file, "The project file")->required()->type_name("NAME.noonmark.gpkg");
}

int changeProject(const std::string& file, const Console& console,
                  const std::function<Result<std::string>(Project&)>& change) {
    auto disk = ProjectFile::open(file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    Project project = disk->project();
    const auto words = change(project);
    if (!words) return fail(console, words.error(), exitUsage);
    if (const auto saved = disk->save(project); !saved) return fail(console, saved.error(), exitFailed);
    console.out << *words;
    return exitOk;
}

Result<Scenario*> scenarioToChange(Project& project, const std::string& name) {
    if (name == existingCity)
        return failure("The existing city is not changed", "scenario 'Existing'",
                       "Add a scenario: noonmark-cli project add-scenario");
    if (const auto known = scenarioNamed(project, name); !known) return tl::make_unexpected(known.error());
    for (Scenario& scenario : project.scenarios)
        if (scenario.name == name) return &scenario;
    return nullptr;
}

}  // namespace noonmark::cli
