#pragma once

#include <stop_token>

#include "core/study/tile_tasks/plan/task_plan.h"
#include "core/study/tile_tasks/plan/tile_subject.h"

namespace noonmark {

/// What a task did.
struct TaskReport {
    std::size_t tiles = 0;
    std::size_t computed = 0;   ///< by this run; the others were done and whole
    std::size_t buildings = 0;  ///< read by this run; those in several windows count in each
    double readSeconds = 0;
    double seconds = 0;
};

/// Computes the tiles of a task that are not done, into the task's folder: a journal, and a raster file for
/// each tile, written under a temporary name and renamed. A tile is done if the journal has it with the
/// content hash of the plan and its file has the size and hash that the journal states. Reads window by
/// window the box that the tiles of a window need together, or whole files if the plan says so; never more
/// than `settings.memoryLimit` is planned for.
///
/// `question`: as the plan was made with. A project among the inputs must have the hash of the plan, other
/// inputs their size. Errors that may pass (isRetryable):
/// another process works on the task, the disk is full, memory ran out, cancelled. Others stay: the plan does
/// not fit the settings or the inputs, a file cannot be read, a tile needs more memory than the limit.
Result<TaskReport> runTask(const std::filesystem::path& folder, const TaskPlan& plan, std::size_t task,
                           const TaskQuestion& question, Progress& progress, const std::stop_token& stop,
                           const EngineList& engines = coreEngines());

/// Whether the same task may succeed later, on another machine or with nothing changed.
bool isRetryable(const Error& error);

}  // namespace noonmark
