#pragma once

#include <CLI/CLI.hpp>

#include "core/study/study.h"

namespace noonmark::cli {

/// Adds --engine KEY and --option NAME=VALUE (repeatable), stored in `settings`, which must outlive the
/// command. makeEngine() checks the combination of engine, option and value.
void addEngineOptions(CLI::App& command, StudySettings& settings);

}  // namespace noonmark::cli
