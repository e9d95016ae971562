#include "core/study/tile_tasks/task_status.h"

#include <fmt/format.h>

#include "core/describe/command_options.h"
#include "core/io/files/plain_file.h"

namespace noonmark {

Result<TaskStatus> findStatus(const std::filesystem::path& folder, const TaskPlan& plan) {
    TaskStatus status{.finished = std::vector<std::map<std::size_t, FinishedTile>>(plan.districts.size())};
    if (auto plain = checkNoLink(taskFolder(folder, 0).parent_path()); !plain)
        return tl::make_unexpected(plain.error());
    double estimatedDone = 0, estimatedLeft = 0;
    for (std::size_t task = 0; task < plan.taskCount; ++task) {
        const std::vector<PlannedTile> tiles = plan.tilesOf(task);
        if (tiles.empty()) continue;
        const std::size_t district = tiles.front().district;
        auto journal = TileJournal::peek(taskFolder(folder, task), plan.studyHash(district),
                                         plan.districts.at(district).tiles);
        if (!journal) return tl::make_unexpected(journal.error());
        std::size_t done = 0;
        for (const PlannedTile& tile : tiles) {
            const auto found = journal->find(tile.number);
            const bool is = found != journal->end() && found->second.contentHash == tile.contentHash;
            (is ? estimatedDone : estimatedLeft) += tile.seconds;
            if (!is) continue;
            ++done;
            status.doneSeconds += found->second.seconds;
            status.finished[district][tile.number] = {std::move(found->second), task};
        }
        status.allTiles += tiles.size();
        status.doneTiles += done;
        if (done == tiles.size()) continue;
        status.unfinishedTasks.push_back(task);
        status.startedTasks += done > 0 ? 1 : 0;
    }
    status.leftSeconds =
        estimatedDone > 0 ? estimatedLeft * status.doneSeconds / estimatedDone : estimatedLeft;
    return status;
}

Result<TaskStatus> findMergeable(const std::filesystem::path& folder, const TaskPlan& plan, bool partial) {
    auto status = findStatus(folder, plan);
    if (!status || status->complete() || partial) return status;
    return failure(
        fmt::format("{} of {} tiles are missing", status->allTiles - status->doneTiles, status->allTiles),
        folder.string(),
        "Run the tasks " + formatRanges(status->unfinishedTasks) + " again, or merge what there is with " +
            flags::partial);
}

std::string formatRanges(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
        if (!text.empty()) text += ',';
        text += fmt::to_string(numbers[i]);
        if (end - i > 1) text += fmt::format("-{}", numbers[end - 1]);
        i = end;
    }
    return text;
}

std::string statusJson(const TaskPlan& plan, const TaskStatus& status) {
    const nlohmann::ordered_json json{{"tasks", plan.taskCount},
                                      {"tasks_unfinished", status.unfinishedTasks.size()},
                                      {"tasks_started", status.startedTasks},
                                      {"unfinished", formatRanges(status.unfinishedTasks)},
                                      {"tiles", status.allTiles},
                                      {"tiles_done", status.doneTiles},
                                      {"done_seconds", status.doneSeconds},
                                      {"left_seconds", status.leftSeconds},
                                      {"complete", status.complete()}};
    return json.dump(2);
}

}  // namespace noonmark
