#pragma once

#include <CLI/CLI.hpp>

namespace noonmark::cli {

/// Adds --overwrite, for all commands that write files (core/io/files/check_output.h).
void addOverwriteOption(CLI::App& command, bool& overwrite);

}  // namespace noonmark::cli
