#pragma once

// The folder app/cli/tiles holds `noonmark-cli tiles`: a study divided among the tasks of a scheduler.
// plan_tiles.cpp makes the plan, tiles_command.cpp finds the task that a scheduler means and computes it,
// finished_tiles.cpp reports on finished tiles and merges them. tile_question.h stores the options of the
// study in the plan, and reads what they ask for.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "app/cli/base/command.h"
#include "core/base/result.h"

namespace noonmark::cli {

/// Exit code of `tiles run` where the work failed and may succeed later: EX_TEMPFAIL of sysexits.h.
inline constexpr auto exitRetry = ExitCode(75);

void addTilesCommand(CLI::App& app, Run& run);
void addPlanTiles(CLI::App& tiles, Run& run);
void addRunTiles(CLI::App& tiles, Run& run);
void addTilesStatus(CLI::App& tiles, Run& run);
void addMergeTiles(CLI::App& tiles, Run& run);

/// The value of an environment variable; nothing if it is not set.
using Environment = std::function<std::optional<std::string>(const char* name)>;
std::optional<std::string> readEnvironment(const char* name);

/// The number that a scheduler gave this process in an array of jobs, from 0: SLURM_ARRAY_TASK_ID,
/// JOB_COMPLETION_INDEX of Kubernetes, or AWS_BATCH_JOB_ARRAY_INDEX, in this order. Error: none is set, or
/// not to a whole number.
Result<std::size_t> findArrayTask(const Environment& environment);

}  // namespace noonmark::cli
