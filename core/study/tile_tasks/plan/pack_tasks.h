#pragma once

#include "core/study/tile_tasks/plan/task_plan.h"

namespace noonmark {

/// What a task may take.
struct TaskSize {
    double seconds = 300;      ///< a task ends when the next tile would exceed it; one tile may
    double memoryBytes = 2e9;  ///< a window ends when the next tile would exceed it; one tile may
};

/// Gives every tile its task and its window, and sorts the tiles by them. Tiles are taken along a
/// space-filling curve (Z-order) of their district. A task runs until its time is used up. It reads its tiles
/// window by window, one after the other: a window is the union of its tiles' halos and ends where that union
/// needs too much memory. Without `plan.byExtent` files are read whole, so that a task has one window. Tasks
/// are numbered from 0; none mixes districts. Returns the number of tasks.
std::size_t packTasks(TaskPlan& plan, const TaskSize& size);

/// The estimated peak of the task that needs the most memory: of its largest window. 0 without tiles.
double largestExtentBytes(const TaskPlan& plan);

}  // namespace noonmark
