#pragma once

#include "app/cli/base/command.h"

namespace noonmark::cli {

/// As the functions of command.h.
void addPointCommand(CLI::App& app, Run& run);

}  // namespace noonmark::cli
