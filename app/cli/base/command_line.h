#pragma once

// The folder app/cli/ is the command line program. command_line.h parses the arguments, commands/ holds one
// file per command and project/ one per subcommand of `project`; options/ holds the options that several
// commands share. The files beside this one read the city, run a study or measure, and print progress, tables
// and errors.

#include "app/cli/base/console.h"

namespace noonmark::cli {

/// The whole program: parses the arguments (argv[0] is skipped), runs one command and returns its ExitCode.
/// Catches all exceptions.
int runCommandLine(int argc, const char* const* argv, const Console& console);

}  // namespace noonmark::cli
