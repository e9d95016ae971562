#pragma once

// The folder app/cli/tiles holds `noonmark-cli tiles`: a study divided among the tasks of a scheduler.
// plan_tiles.cpp makes the plan, run_tiles.cpp computes one task, finished_tiles.cpp reports on them and
// merges them. study_arguments.h stores the options of the study in the plan, and tile_question.h reads what
// they ask for; array_task.h finds the task that a scheduler means.

#include <CLI/CLI.hpp>

#include "app/cli/base/command.h"

namespace noonmark::cli {

/// Exit code of `tiles run` where the work failed and may succeed later: EX_TEMPFAIL of sysexits.h.
inline constexpr auto exitRetry = ExitCode(75);

void addTilesCommand(CLI::App& app, Run& run);
void addPlanTiles(CLI::App& tiles, Run& run);
void addRunTiles(CLI::App& tiles, Run& run);
void addTilesStatus(CLI::App& tiles, Run& run);
void addMergeTiles(CLI::App& tiles, Run& run);

}  // namespace noonmark::cli
