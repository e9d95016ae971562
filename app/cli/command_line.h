#pragma once

#include "app/cli/console.h"

namespace noonmark::cli {

/// The whole program: reads the arguments (argv[0] is skipped), runs one command, returns its ExitCode.
/// Catches everything.
int runCommandLine(int argc, const char* const* argv, const Console& console);

}  // namespace noonmark::cli
