#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "app/cli/base/command.h"
#include "core/base/result.h"

namespace noonmark::cli {

// The folder app/cli/tiles holds `noonmark-cli tiles`: a study divided among the tasks of a scheduler.
// plan_tiles.cpp makes the plan, tiles_command.cpp computes one task, finished_tiles.cpp reports on them and
// merges them. tile_question.h stores the options of the study in the plan, and tile_question.h reads what
// they ask for; tiles_command.h finds the task that a scheduler means.

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
