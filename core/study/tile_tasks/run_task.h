#pragma once

#include <map>
#include <stop_token>

#include "core/study/tile_tasks/plan/task_plan.h"
#include "core/study/tiles/tile_maps.h"

namespace noonmark {

/// A finished tile of a plan.
struct FinishedTile {
    TileResult result;
    std::size_t task = 0;
};

/// The state of a plan: what its tasks have finished so far.
struct TaskStatus {
    /// The finished tiles by district and number. Only tiles whose content is the plan's and whose file has
    /// its size.
    std::vector<std::map<std::size_t, FinishedTile>> finished;
    std::vector<std::size_t> unfinishedTasks;  ///< ascending
    std::size_t startedTasks = 0;              ///< of them, those that have finished some tile
    std::size_t doneTiles = 0, allTiles = 0;
    double doneSeconds = 0;  ///< that the finished tiles took
    double leftSeconds = 0;  ///< that the others are estimated to take, scaled by what the finished ones took

    [[nodiscard]] bool complete() const { return doneTiles == allTiles; }
    /// What trees reach any finished tile in; districts that none reaches count as they are.
    [[nodiscard]] TreeColumns treeColumns() const;
};

/// Reads the journals of all tasks, also while they are written. Error: a journal of another study.
Result<TaskStatus> findStatus(const std::filesystem::path& folder, const TaskPlan& plan);

/// The same, to be merged. Error: tiles are missing, unless `partial`.
Result<TaskStatus> findMergeable(const std::filesystem::path& folder, const TaskPlan& plan, bool partial);

/// "0-3,7,9": as schedulers take a list of array tasks.
std::string formatRanges(const std::vector<std::size_t>& numbers);

/// Keys: tasks, tasks_unfinished, tasks_started, unfinished, tiles, tiles_done, done_seconds, left_seconds,
/// complete.
std::string statusJson(const TaskPlan& plan, const TaskStatus& status);

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
