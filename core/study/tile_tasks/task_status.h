#pragma once

#include <map>

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
    /// By district, by tile number. Only tiles whose content is the plan's and whose file has its size.
    std::vector<std::map<std::size_t, FinishedTile>> finished;
    std::vector<std::size_t> unfinishedTasks;  ///< ascending
    std::size_t startedTasks = 0;              ///< of them, those that have finished some tile
    std::size_t doneTiles = 0, allTiles = 0;
    double doneSeconds = 0;  ///< that the finished tiles took
    double leftSeconds = 0;  ///< that the others are estimated to take, scaled by what the finished ones took

    [[nodiscard]] bool complete() const { return doneTiles == allTiles; }
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

}  // namespace noonmark
