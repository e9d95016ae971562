#include "app/cli/study/load_city.h"

#include <algorithm>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/progress_line.h"
#include "app/input/load_project.h"
#include "core/io/settings/read_settings_text.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

Result<LoadedCity> projectCity(const std::string& file) {
    return ProjectFile::open(file).map(
        [&](const ProjectFile& disk) { return loadProjectCity(disk.project(), file); });
}

}  // namespace

bool namesProject(const ReadOptions& options) { return std::ranges::any_of(options.files, isProjectFile); }

Result<void> checkProjectAlone(const ReadOptions& options) {
    const std::string& file = options.files.front();
    if (options.files.size() > 1)
        return failure("A project cannot be combined with other files", file, "Give only the project file");
    if (formatText(options.settings).empty()) return {};
    return failure("The city of a project has already been read: reading options have no effect", file,
                   "Omit them, or create a new project from the files with these options");
}

Result<LoadedCity> loadCity(const ReadOptions& options, const Console& console) {
    if (namesProject(options))
        return checkProjectAlone(options).and_then([&] { return projectCity(options.files.front()); });
    const Interrupt interrupt;
    ProgressLine progress(console);
    return noonmark::loadCity(options.files, options.settings, progress, interrupt.token());
}

}  // namespace noonmark::cli
