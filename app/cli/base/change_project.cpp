#include "app/cli/base/change_project.h"

#include <ostream>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/input/load_city.h"

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

Result<ProjectFile> openProject(const std::string& file, const Console& console) {
    auto disk = ProjectFile::open(file);
    if (!disk) return disk;
    const Interrupt interrupt;
    NoProgress progress;
    Warnings warnings;
    disk->setCityWithPictures(
        withLoadedPhotograph(disk->project(), warnings, progress, interrupt.token()).city);
    if (interrupt.token().stop_requested()) return cancelled();
    printWarnings(console.err, warnings);
    return disk;
}

}  // namespace noonmark::cli
