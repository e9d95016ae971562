#pragma once

#include <iosfwd>

namespace noonmark::cli {

/// Where a command speaks to.
struct Console {
    std::ostream& out;     ///< results
    std::ostream& err;     ///< the one line of an error, the progress line
    bool watched = false;  ///< a person looks at `err`: show progress there
};

/// What the program ends with.
enum ExitCode : int {
    exitOk = 0,
    exitFailed = 1,      ///< the work could not be done
    exitUsage = 2,       ///< the command line is wrong, or a file cannot be read
    exitCancelled = 130  ///< Ctrl-C, as shells have it
};

}  // namespace noonmark::cli
