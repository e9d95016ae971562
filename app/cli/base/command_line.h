#pragma once

// The folder app/cli/ is the command line program. runCommandLine() (this file) parses the arguments;
// commands/ holds one file per command, project/ one per subcommand of `project`, and options/ the options
// that several commands share. The other files of base/ change projects, save cities, and print
// progress, tables and errors.

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

/// The whole program: parses the arguments (argv[0] is skipped), runs one command and returns its ExitCode.
/// Catches all exceptions.
int runCommandLine(int argc, const char* const* argv, const Console& console);

}  // namespace noonmark::cli
