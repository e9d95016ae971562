#pragma once

#include <CLI/CLI.hpp>

#include "core/study/study.h"

namespace noonmark::cli {

/// --engine KEY and --option NAME=VALUE (any number of them), into `settings`, which outlives the command.
/// Whether engine, option and value go together is makeEngine's to say.
void addEngineOptions(CLI::App& command, StudySettings& settings);

}  // namespace noonmark::cli
