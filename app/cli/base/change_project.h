#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

#include "app/cli/base/command.h"
#include "app/cli/base/command_line.h"
#include "scenarios/project/project.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

/// Options shared by all commands that change a project.
struct ChangeOptions {
    std::string file;
    bool dryRun = false;  ///< report the changes without saving
};

/// Adds the project file argument.
void addProjectFile(CLI::App& command, std::string& file);

/// Opens a project, changes and saves it, and prints the text that `change` returns. Nothing is saved on an
/// Error.
int changeProject(const ChangeOptions& options, const Console& console,
                  const std::function<Result<std::string>(Project&)>& change);

/// Adds a command that changes a project. `Options` must have a member `ChangeOptions change`.
template <class Options>
CLI::App* addChangeCommand(CLI::App& group, const char* name, const char* about,
                           const std::shared_ptr<Options>& options,
                           Result<std::string> (*change)(const Options&, Project&), Run& run) {
    CLI::App* command = group.add_subcommand(name, about);
    addProjectFile(*command, options->change.file);
    command->add_flag("--dry-run", options->change.dryRun, "Report the changes without saving them");
    command->callback([options, change, &run] {
        run = [options, change](const Console& console) {
            return changeProject(options->change, console,
                                 [&](Project& project) { return change(*options, project); });
        };
    });
    return command;
}

/// Opens a project for a command that draws it: with the pixels of its aerial photograph, if it shows one.
/// A photograph that cannot be drawn is a warning on `console.err`. Error: as of ProjectFile::open().
Result<ProjectFile> openProject(const std::string& file, const Console& console);

}  // namespace noonmark::cli
