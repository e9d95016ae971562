#pragma once

#include <iosfwd>

namespace noonmark::cli {

/// The output streams of a command.
struct Console {
    std::ostream& out;     ///< results
    std::ostream& err;     ///< error and progress lines
    bool watched = false;  ///< `err` is a terminal: show progress there
};

/// Exit codes of the program.
enum ExitCode : int {
    exitOk = 0,
    exitFailed = 1,      ///< the work failed
    exitUsage = 2,       ///< the command line is wrong, or a file cannot be read
    exitCancelled = 130  ///< Ctrl-C, as in shells
};

// The folder app/cli/ is the command line program. command_line.h parses the arguments, commands/ holds one
// file per command and project/ one per subcommand of `project`; options/ holds the options that several
// commands share. The files beside this one read the city, run a study or measure, and print progress, tables
// and errors.

/// The whole program: parses the arguments (argv[0] is skipped), runs one command and returns its ExitCode.
/// Catches all exceptions.
int runCommandLine(int argc, const char* const* argv, const Console& console);

}  // namespace noonmark::cli
