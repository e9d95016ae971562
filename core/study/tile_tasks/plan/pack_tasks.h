#pragma once

#include "core/study/tile_tasks/plan/task_plan.h"

namespace noonmark {

/// What a task may take.
struct TaskSize {
    double seconds = 300;      ///< a task ends when the next tile would exceed it; one tile may
    double memoryBytes = 2e9;  ///< the same for its estimated peak
};

/// Gives every tile its task and sorts the tiles by it. Tasks are compact: tiles are taken along a
/// space-filling curve (Z-order) of their district, since a task reads the union of its tiles' halos. Tasks
/// are numbered from 0; none mixes districts. Returns the number of tasks.
std::size_t packTasks(TaskPlan& plan, const TaskSize& size);

}  // namespace noonmark
