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

}  // namespace noonmark::cli
