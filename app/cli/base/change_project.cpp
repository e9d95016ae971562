#include "app/cli/base/change_project.h"

#include <ostream>

#include "scenarios/project/project_file.h"

namespace noonmark::cli {

void addProjectFile(CLI::App& command, std::string& file) {
    command.add_option("project", file, "The project file")->required()->type_name("NAME.noonmark.gpkg");
}

int changeProject(const ChangeOptions& options, const Console& console,
                  const std::function<Result<std::string>(Project&)>& change) {
    auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    Project project = disk->project();
    const auto words = change(project);
    if (!words) return fail(console, words.error(), exitUsage);
    if (const auto sound = validate(project); !sound) return fail(console, sound.error(), exitUsage);
    if (!options.dryRun)
        if (const auto saved = disk->save(project); !saved) return fail(console, saved.error(), exitFailed);
    console.out << *words << (options.dryRun ? "Dry run: nothing was saved\n" : "");
    return exitOk;
}

}  // namespace noonmark::cli
