#include "core/study/tile_tasks/run_task.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/memory_guard.h"
#include "core/base/stopwatch.h"
#include "core/io/read_window.h"
#include "core/study/memory_need.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/remaining_time.h"
#include "core/study/tile_tasks/plan/find_districts.h"
#include "core/study/tiles/tile_runner.h"

namespace noonmark {

namespace {

Result<void> checkTask(const TaskPlan& plan, std::size_t task, const StudySettings& settings) {
    if (task >= plan.taskCount)
        return failure(fmt::format("There is no task {}: the plan has tasks 0 to {}", task,
                                   plan.taskCount == 0 ? 0 : plan.taskCount - 1),
                       "task", "Set the size of the array to the number of tasks");
    if (hashSettings(settings) == plan.settingsHash) return {};
    return failure("The plan was made by another version of Noonmark", planFileName,
                   "Plan again with this version");
}

// A hash of large files would take longer than the task: the size tells most changes.
Result<void> checkInputs(const TaskPlan& plan) {
    for (const InputFile& input : plan.inputs) {
        std::error_code error;
        const auto bytes = std::filesystem::file_size(input.path, error);
        if (error)
            return failure("An input of the plan cannot be found: " + error.message(), input.path.string(),
                           "Make it available under this path, or plan again");
        if (bytes != input.bytes)
            return failure("An input has changed since the plan was made", input.path.string(), "Plan again");
    }
    return {};
}

bool isDone(const PlannedTile& tile, const TileJournal& journal) {
    const auto found = journal.finished().find(tile.number);
    if (found == journal.finished().end() || found->second.contentHash != tile.contentHash) return false;
    if (found->second.empty()) return true;
    const auto file = describeInputFile(journal.fileOf(tile.number));
    return file && file->sha256 == found->second.fileSha256;
}

std::vector<PlannedTile> findMissing(const std::vector<PlannedTile>& tiles, const TileJournal& journal) {
    std::vector<PlannedTile> missing;
    std::ranges::copy_if(tiles, std::back_inserter(missing),
                         [&](const PlannedTile& tile) { return !isDone(tile, journal); });
    return missing;
}

Result<City> readFor(const std::vector<PlannedTile>& tiles, const TaskPlan& plan, const District& district,
                     const ReadSettings& reading, Progress& progress, const std::stop_token& stop) {
    Box2 box;
    for (const PlannedTile& tile : tiles) box.add(tile.reads);
    const ReadWindow window{makeLonLatBox(district.frame, glm::dvec2(box.low), glm::dvec2(box.high)),
                            nullptr};
    const auto files = pathsOf(plan.files);
    auto read = plan.byWindow
                    ? readCityWindow(files, readSettingsIn(district, reading), window, progress, stop)
                    : readCity(files, reading, progress, stop);
    if (!read) return tl::make_unexpected(read.error());
    if (read->city.frame == district.frame) return std::move(read->city);
    return failure("An input has changed since the plan was made", plan.files.front(), "Plan again");
}

Result<void> checkTaskMemory(const City& city, const District& district, StudySettings settings,
                             const EngineList& engines) {
    const Grid tile = district.tiles.tile(0);
    const auto cellM = float(tile.cellM);
    settings.region =
        makeRegionFromLocalBox({{0, 0}, {cellM * float(tile.columns), cellM * float(tile.rows)}});
    return checkMemory(city, settings, engines);
}

Result<void> compute(const std::vector<PlannedTile>& missing, const City& city, const StudySettings& settings,
                     const District& district, TileJournal& journal, Progress& progress,
                     const std::stop_token& stop, const EngineList& engines) {
    const auto engine = makeEngine(settings.engine, settings.engineSettings, engines);
    if (!engine) return tl::make_unexpected(engine.error());
    const auto sun = computeDaylightSteps(settings.period, makeObserver(city, settings), stop);
    if (!sun) return tl::make_unexpected(sun.error());
    TileRunner runner(city, settings, *sun, **engine, district.tiles, journal);
    double cells = 0;
    for (const PlannedTile& tile : missing) cells += double(district.tiles.tile(tile.number).size());
    PiecewiseProgress pieces(progress, cells, 0);
    for (std::size_t i = 0; i < missing.size(); ++i) {
        if (stop.stop_requested()) return cancelled();
        pieces.begin(fmt::format("tile {} of {}", i + 1, missing.size()),
                     double(district.tiles.tile(missing[i].number).size()));
        auto done = runner.run(missing[i].number, pieces, stop, missing[i].contentHash);
        if (!done) return done;
        pieces.end();
    }
    return {};
}

Result<TaskReport> run(const std::filesystem::path& folder, const TaskPlan& plan, std::size_t task,
                       const ReadSettings& reading, StudySettings settings, Progress& progress,
                       const std::stop_token& stop, const EngineList& engines) {
    const Stopwatch watch;
    settings.region = {};
    if (auto sound = checkTask(plan, task, settings); !sound) return tl::make_unexpected(sound.error());
    const std::vector<PlannedTile> tiles = plan.tilesOf(task);
    const std::size_t number = tiles.front().district;
    const District& district = plan.districts.at(number);
    settings.region = district.region;
    auto journal = TileJournal::open(taskFolder(folder, task), plan.studyHash(number), district.tiles);
    if (!journal) return tl::make_unexpected(journal.error());
    const std::vector<PlannedTile> missing = findMissing(tiles, *journal);
    TaskReport report{.tiles = tiles.size(), .computed = missing.size()};
    if (missing.empty()) return report;
    if (auto same = checkInputs(plan); !same) return tl::make_unexpected(same.error());
    const auto city = readFor(missing, plan, district, reading, progress, stop);
    if (!city) return tl::make_unexpected(city.error());
    report.buildings = city->buildings.size();
    report.readSeconds = watch.seconds();
    return checkTaskMemory(*city, district, settings, engines)
        .and_then(
            [&] { return compute(missing, *city, settings, district, *journal, progress, stop, engines); })
        .map([&] {
            report.seconds = watch.seconds();
            return report;
        });
}

}  // namespace

Result<TaskReport> runTask(const std::filesystem::path& folder, const TaskPlan& plan, std::size_t task,
                           const ReadSettings& reading, const StudySettings& settings, Progress& progress,
                           const std::stop_token& stop, const EngineList& engines) {
    return guardMemory({.what = "this task", .advice = "Give it more memory, or plan smaller tasks"},
                       [&] { return run(folder, plan, task, reading, settings, progress, stop, engines); });
}

bool isRetryable(const Error& error) { return error.kind == ErrorKind::limit || isCancelled(error); }

}  // namespace noonmark
