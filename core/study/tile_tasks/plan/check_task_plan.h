#pragma once

#include "core/study/tile_tasks/plan/task_plan.h"

namespace noonmark {

/// Whether a plan that was read is one that makeTaskPlan() could have made: numbers finite and in range,
/// names of districts that stay in the folder, tiles of the districts, sorted by tasks, none empty,
/// that do not mix districts, and in them by windows. plan.json may come from a stranger.
bool isSound(const TaskPlan& plan);

}  // namespace noonmark
