#include "core/study/tile_tasks/run_task.h"

#include <fmt/format.h>
#include <algorithm>

#include "core/base/memory_guard.h"
#include "core/base/progress.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "core/io/files/plain_file.h"
#include "core/io/read_region.h"
#include "core/study/tile_tasks/plan/find_districts.h"
#include "core/study/tiles/shadow_measure.h"
#include "core/study/tiles/tile_runner.h"
#include "core/study/tiles/tiled_study.h"

namespace noonmark {

namespace {

// Its file may be damaged.
bool isMeasured(const PlannedTile& tile, const TileResult& found) {
    return found.contentHash == tile.contentHash && !found.hasTrees;
}

}  // namespace

TreeColumns TaskStatus::treeColumns() const {
    std::vector<const TileResult*> results;
    for (const auto& ofDistrict : finished)
        for (const auto& [number, tile] : ofDistrict) results.push_back(&tile.result);
    return findColumns(results);
}

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
            const bool is = found != journal->end() && isMeasured(tile, found->second);
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
    return failure(fmt::format("Missing: {} of {}", status->allTiles - status->doneTiles,
                               countOf(status->allTiles, "tile")),
                   folder.string(),
                   "Run the tasks " + formatRanges(status->unfinishedTasks) +
                       " again, or merge what there is with " + flags::partial);
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

namespace {

Result<void> checkTask(const TaskPlan& plan, std::size_t task, const TaskQuestion& question) {
    if (task >= plan.taskCount)
        return failure(fmt::format("There is no task {}: the plan has tasks 0 to {}", task,
                                   plan.taskCount == 0 ? 0 : plan.taskCount - 1),
                       "task", "Set the size of the array to the number of tasks");
    if (hashQuestion(question) == plan.settingsHash) return {};
    return failure("The plan was made by another version of Noonmark, for other scenarios or other places",
                   planFileName, "Plan again with this version");
}

// A hash of large files would take longer than the task: the size tells most changes. A project changes
// without growing, and is small.
Result<void> checkInputs(const TaskPlan& plan, bool byHash) {
    for (const InputFile& input : plan.inputs) {
        std::error_code error;
        const auto bytes = std::filesystem::file_size(input.path, error);
        if (error)
            return failure("An input of the plan cannot be found: " + error.message(), input.path.string(),
                           "Make it available under this path, or plan again");
        const auto now = byHash && bytes == input.bytes ? describeInputFile(input.path) : input;
        if (!now) return tl::make_unexpected(now.error());
        if (bytes != input.bytes || now->sha256 != input.sha256)
            return failure("An input has changed since the plan was made", input.path.string(), "Plan again");
    }
    return {};
}

bool isDone(const PlannedTile& tile, const TileJournal& journal) {
    const auto found = journal.finished().find(tile.number);
    if (found == journal.finished().end() || !isMeasured(tile, found->second)) return false;
    if (found->second.empty()) return true;
    const auto file = describeInputFile(journal.fileOf(found->second));
    return file && file->sha256 == found->second.fileSha256;
}

Result<City> readFor(const std::vector<PlannedTile>& tiles, const TaskPlan& plan, const District& district,
                     const TaskQuestion& question, std::shared_ptr<const Terrain> terrain, Progress& progress,
                     const std::stop_token& stop) {
    if (question.subject != nullptr) return *question.subject->cities.back();
    const ReadSettings& reading = question.reading;
    Box2 box;
    for (const PlannedTile& tile : tiles) box.add(tile.reads);
    const ReadExtent window{makeLonLatBox(district.frame, glm::dvec2(box.low), glm::dvec2(box.high)),
                            std::move(terrain), plan.fileBoxes};
    const auto files = pathsOf(plan.files);
    auto read = plan.byExtent
                    ? readCityExtent(files, readSettingsIn(district, reading), window, progress, stop)
                    : readCity(files, reading, progress, stop);
    if (!read) return tl::make_unexpected(read.error());
    return std::move(read->city);
}

/// The tiles of a task that are not done, by window.
std::vector<std::vector<PlannedTile>> findMissing(const std::vector<PlannedTile>& tiles,
                                                  const TileJournal& journal) {
    std::vector<std::vector<PlannedTile>> windows;
    for (const PlannedTile& tile : tiles) {
        if (isDone(tile, journal)) continue;
        if (windows.empty() || windows.back().back().window != tile.window) windows.emplace_back();
        windows.back().push_back(tile);
    }
    return windows;
}

TileTotals countTiles(const std::vector<PlannedTile>& tiles, const TilePlan& plan) {
    TileTotals count;
    for (const PlannedTile& tile : tiles) count.add(plan.tile(tile.number));
    return count;
}

TilesLeft makeTilesLeft(const std::vector<PlannedTile>& window, TileTotals done, TileTotals later) {
    TilesLeft left{.missing = {}, .done = done, .later = later};
    for (const PlannedTile& tile : window) left.missing.push_back({tile.number, tile.contentHash});
    return left;
}

const City* baselineOf(const TileSubject* subject) {
    return subject == nullptr || subject->cities.size() < 2 ? nullptr : subject->cities.front().get();
}

std::unique_ptr<TileMeasure> makeByPlaceMeasure(const City& city, const TaskQuestion& question,
                                                const TileQuestion& inTiles, const PlacesOfTiles& places,
                                                const EngineList& engines) {
    std::vector<const City*> cities{&city};
    if (const City* baseline = baselineOf(question.subject)) cities.insert(cities.begin(), baseline);
    return std::make_unique<ByPlaceMeasure>(std::move(cities), places, *question.byPlace, inTiles, engines);
}

/// `places`: those that are measured instead of cells.
std::unique_ptr<TileMeasure> makeMeasure(const City& city, const TaskQuestion& question,
                                         const TileQuestion& inTiles, const PlacesOfTiles& places,
                                         const EngineList& engines) {
    const TileSubject* subject = question.subject;
    if (question.byPlace != nullptr) return makeByPlaceMeasure(city, question, inTiles, places, engines);
    if (question.timelines != nullptr) {
        const City* baseline = baselineOf(subject);
        return baseline == nullptr
                   ? std::make_unique<TimelineMeasure>(city, nullptr, places, *question.timelines, inTiles)
                   : std::make_unique<TimelineMeasure>(*baseline, &city, places, *question.timelines,
                                                       inTiles);
    }
    if (subject != nullptr && subject->measure) return subject->measure(inTiles);
    return std::make_unique<ShadowMeasure>(city, inTiles);
}

/// One run of a task.
class TaskRun {
public:
    TaskRun(const TaskPlan& plan, const District& district, const TaskQuestion& question,
            TileJournal& journal, const EngineList& engines)
        : plan_(plan), district_(district), question_(question), journal_(journal), engines_(engines) {}

    Result<TaskReport> run(const std::vector<PlannedTile>& tiles, Progress& progress,
                           const std::stop_token& stop) {
        const Stopwatch watch;
        const auto windows = findMissing(tiles, journal_);
        report_ = {.tiles = tiles.size()};
        for (const auto& window : windows) later_.add(countTiles(window, district_.tiles));
        done_ = countTiles(tiles, district_.tiles);
        done_.subtract(later_);
        if (!windows.empty())
            if (auto same = checkInputs(plan_, question_.subject != nullptr); !same)
                return tl::make_unexpected(same.error());
        for (const auto& window : windows)
            if (auto done = runExtent(window, progress, stop); !done)
                return tl::make_unexpected(done.error());
        report_.seconds = watch.seconds();
        return report_;
    }

private:
    Result<void> runExtent(const std::vector<PlannedTile>& window, Progress& progress,
                           const std::stop_token& stop) {
        const Stopwatch watch;
        const auto city = readFor(window, plan_, district_, question_, terrain_, progress, stop);
        if (!city) return tl::make_unexpected(city.error());
        if (city->frame != district_.frame)
            return failure("An input has changed since the plan was made", plan_.files.front(), "Plan again");
        terrain_ = city->terrain;
        report_.buildings += city->buildings.size();
        report_.readSeconds += watch.seconds();
        if (auto fits = checkTileMemory(*city, district_.tiles, question_.settings, engines_); !fits)
            return fits;
        const TileTotals count = countTiles(window, district_.tiles);
        later_.subtract(count);
        return compute(makeTilesLeft(window, done_, later_), *city, progress, stop).map([&] {
            done_.add(count);
            report_.computed += window.size();
        });
    }

    Result<void> compute(const TilesLeft& left, const City& city, Progress& progress,
                         const std::stop_token& stop) {
        const StudySettings& settings = question_.settings;
        const auto engine = makeEngine(settings.engine, settings.engineSettings, engines_);
        if (!engine) return tl::make_unexpected(engine.error());
        const auto sun = computeDaylightSteps(settings.period, makeObserver(city, settings), stop);
        if (!sun) return tl::make_unexpected(sun.error());
        if (auto read = readPlacesOnce(progress, stop); !read) return read;
        const auto measure = makeMeasure(city, question_, {settings, *sun, **engine, district_.tiles.whole},
                                         *places_, engines_);
        TileRunner runner(*measure, district_.tiles, city.frame, journal_);
        return runTiles(runner, district_.tiles, left, progress, stop);
    }

    Result<void> readPlacesOnce(Progress& progress, const std::stop_token& stop) {
        if (places_) return {};
        std::vector<Place> places;
        if (const PlacesRequest* request = question_.places()) {
            auto read = readPlaces(*request, district_.frame, progress, stop);
            if (!read) return tl::make_unexpected(read.error());
            places = *std::move(read);
        }
        places_.emplace(std::move(places), district_.tiles);
        return {};
    }

    const TaskPlan& plan_;
    const District& district_;
    const TaskQuestion& question_;
    TileJournal& journal_;
    const EngineList& engines_;
    TaskReport report_;
    TileTotals done_, later_;
    std::shared_ptr<const Terrain> terrain_;  ///< of the district, once the first window was read
    std::optional<PlacesOfTiles> places_;     ///< none where cells are measured
};

Result<TaskReport> run(const std::filesystem::path& folder, const TaskPlan& plan, std::size_t task,
                       TaskQuestion question, Progress& progress, const std::stop_token& stop,
                       const EngineList& engines) {
    if (auto sound = checkTask(plan, task, question); !sound) return tl::make_unexpected(sound.error());
    const std::vector<PlannedTile> tiles = plan.tilesOf(task);
    const std::size_t number = tiles.front().district;
    const District& district = plan.districts.at(number);
    question.settings.region = district.region;
    if (auto plain = checkNoLink(taskFolder(folder, task).parent_path()); !plain)
        return tl::make_unexpected(plain.error());
    auto journal = TileJournal::open(taskFolder(folder, task), plan.studyHash(number), district.tiles);
    if (!journal) return tl::make_unexpected(journal.error());
    return TaskRun(plan, district, question, *journal, engines).run(tiles, progress, stop);
}

}  // namespace

Result<TaskReport> runTask(const std::filesystem::path& folder, const TaskPlan& plan, std::size_t task,
                           const TaskQuestion& question, Progress& progress, const std::stop_token& stop,
                           const EngineList& engines) {
    return guardMemory({.what = "this task", .advice = "Give it more memory, or plan smaller tasks"},
                       [&] { return run(folder, plan, task, question, progress, stop, engines); });
}

bool isRetryable(const Error& error) { return error.kind == ErrorKind::limit || isCancelled(error); }

}  // namespace noonmark
