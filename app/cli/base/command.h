#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "app/cli/base/command_line.h"
#include "core/base/result.h"
#include "core/describe/command_options.h"

namespace noonmark::cli {

/// The work of a parsed command; set by the command that the user chose.
using Run = std::function<int(const Console&)>;

// Each function adds a command with its options; the command sets `run` when the user chooses it. A new
// command needs one file and one line in command_line.cpp.
void addSampleCommand(CLI::App& app, Run& run);
void addInfoCommand(CLI::App& app, Run& run);
void addImportCommand(CLI::App& app, Run& run);
void addSunCommand(CLI::App& app, Run& run);
void addStudyCommand(CLI::App& app, Run& run);
void addCityStudyCommand(CLI::App& app, Run& run);
void addBenchCommand(CLI::App& app, Run& run);
void addProjectCommand(CLI::App& app, Run& run);
void addImpactCommand(CLI::App& app, Run& run);
void addScenariosCommand(CLI::App& app, Run& run);
void addScoreCommand(CLI::App& app, Run& run);
void addReviewCommand(CLI::App& app, Run& run);
void addEnginesCommand(CLI::App& app, Run& run);
void addDevicesCommand(CLI::App& app, Run& run);
void addPlacesCommand(CLI::App& app, Run& run);
void addByPlaceCommand(CLI::App& app, Run& run);
void addScreenCommand(CLI::App& app, Run& run);
void addTimelineCommand(CLI::App& app, Run& run);
void addVerifyCommand(CLI::App& app, Run& run);
void addDescribeCommand(CLI::App& app, Run& run);

/// Adds --json, for commands that print JSON instead of words.
inline CLI::Option* addJsonFlag(CLI::App& command, bool& json,
                                const std::string& help = "Print only JSON to standard output") {
    return command.add_flag(flags::json, json, help);
}

/// Prints one line to `err`: "noonmark-cli: what". Returns the code, or exitCancelled if the error is a
/// cancellation.
int fail(const Console& console, const Error& error, ExitCode code);

/// As the functions above.
void addPointCommand(CLI::App& app, Run& run);

}  // namespace noonmark::cli
