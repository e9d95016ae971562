#pragma once

#include <CLI/CLI.hpp>

namespace noonmark::cli {

/// Adds --overwrite, for all commands that write files (core/io/files/check_output.h).
void addOverwriteOption(CLI::App& command, bool& overwrite);
/// Adds --with-project, for commands that measure a project (copyProject()).
void addProjectCopyOption(CLI::App& command, bool& withProject);

}  // namespace noonmark::cli
