#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "app/cli/console.h"
#include "core/base/result.h"

namespace noonmark::cli {

/// What a parsed command does. Set by the command that the user chose.
using Run = std::function<int(const Console&)>;

// Each adds its command with its options, and sets `run` when it is chosen. To add a command: one file, and
// one line in command_line.cpp.
void addSampleCommand(CLI::App& app, Run& run);
void addInfoCommand(CLI::App& app, Run& run);
void addImportCommand(CLI::App& app, Run& run);
void addSunCommand(CLI::App& app, Run& run);
void addStudyCommand(CLI::App& app, Run& run);
void addCityStudyCommand(CLI::App& app, Run& run);
void addBenchCommand(CLI::App& app, Run& run);
void addProjectCommand(CLI::App& app, Run& run);
void addImpactCommand(CLI::App& app, Run& run);
void addScoreCommand(CLI::App& app, Run& run);
void addEnginesCommand(CLI::App& app, Run& run);
void addDevicesCommand(CLI::App& app, Run& run);

/// One line on `err`: "noonmark-cli: what". Returns the code; exitCancelled when the error says that the work
/// was cancelled.
int fail(const Console& console, const Error& error, ExitCode code);

}  // namespace noonmark::cli
