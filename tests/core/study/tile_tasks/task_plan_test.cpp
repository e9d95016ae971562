#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/write_city.h"
#include "core/io/write_raster.h"
#include "core/study/tile_tasks/merge/merge_tiles.h"
#include "core/study/tile_tasks/plan/make_task_plan.h"
#include "core/study/tile_tasks/run_task.h"
#include "core/study/tile_tasks/task_status.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/cityjson_fixtures.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;
using testing::Not;

TaskPlan planOf(std::size_t side, double seconds, double bytes) {
    TaskPlan plan;
    plan.districts.push_back({.name = "d", .tiles = {{0, 0, 1, int(side) * 64, int(side) * 64}, 64}});
    for (std::size_t i = 0; i < side * side; ++i)
        plan.tiles.push_back({.number = i,
                              .reads = {{0, 0}, {1, 1}},
                              .seconds = seconds,
                              .memoryBytes = bytes,
                              .readBytes = bytes / 2});
    return plan;
}

TEST(PackTasks, FillsTasksUpToTheirLength) {
    TaskPlan plan = planOf(4, 10, 1e6);
    EXPECT_EQ(packTasks(plan, {40, 1e9}), 4U);
    for (std::size_t task = 0; task < 4; ++task) {
        const auto tiles = plan.tilesOf(task);
        ASSERT_EQ(tiles.size(), 4U);
        // Four neighbours: 2 x 2 tiles
        EXPECT_EQ(tiles.front().number + 5, tiles.back().number);
    }
}

TEST(PackTasks, ATileThatIsTooLongAloneGetsItsOwnTask) {
    TaskPlan plan = planOf(2, 100, 1e6);
    EXPECT_EQ(packTasks(plan, {40, 1e9}), 4U);
}

TEST(PackTasks, NeverMixesDistricts) {
    TaskPlan plan = planOf(2, 1, 1e6);
    plan.districts.push_back(plan.districts.front());
    plan.tiles[1].district = plan.tiles[3].district = 1;
    EXPECT_EQ(packTasks(plan, {1000, 1e9}), 2U);
    EXPECT_EQ(plan.tilesOf(0).size(), 2U);
}

TEST(PackTasks, AUnionOfHalosThatNeedsTooMuchMemoryIsReadInWindows) {
    TaskPlan plan = planOf(2, 1, 1e9);
    plan.byWindow = true;
    plan.tiles[2].reads = {{2, 2}, {3, 3}};  // with the others 9 m2: 0.5 GB + 9 x 0.5 GB
    plan.tiles[3].reads = {{2, 2}, {3, 3}};
    EXPECT_EQ(packTasks(plan, {1000, 2e9}), 1U);
    std::vector<std::size_t> windows;
    for (const PlannedTile& tile : plan.tiles) windows.push_back(tile.window);
    EXPECT_EQ(windows, (std::vector<std::size_t>{0, 0, 1, 1}));
}

TEST(PackTasks, EveryTaskBeginsItsWindowsAnew) {
    TaskPlan plan = planOf(2, 10, 1e9);
    plan.byWindow = true;
    for (std::size_t i = 0; i < 4; ++i)  // two of them: 0.5 GB + 3 x 0.5 GB
        plan.tiles[i].reads = {{2 * i, 0}, {2 * i + 1, 1}};
    EXPECT_EQ(packTasks(plan, {20, 1.9e9}), 2U);
    for (std::size_t task = 0; task < 2; ++task) {
        EXPECT_EQ(plan.tilesOf(task).front().window, 0U);
        EXPECT_EQ(plan.tilesOf(task).back().window, 1U);
    }
}

TEST(PackTasks, FilesReadWholeAreReadOnce) {
    TaskPlan plan = planOf(2, 1, 1e9);
    plan.tiles[3].reads = {{2, 2}, {3, 3}};
    EXPECT_EQ(packTasks(plan, {1000, 1}), 1U);
    for (const PlannedTile& tile : plan.tiles) EXPECT_EQ(tile.window, 0U);
}

TEST(PackTasks, TheLargestWindowIsThatOfTheUnionOfItsHalos) {
    TaskPlan plan = planOf(2, 1, 100);
    EXPECT_DOUBLE_EQ(largestWindowBytes(TaskPlan()), 0);
    packTasks(plan, {1e6, 1e9});
    EXPECT_DOUBLE_EQ(largestWindowBytes(plan), 100) << "all halos are the same square metre";
    for (std::size_t i = 0; i < 4; ++i) {
        const auto west = float(i);
        plan.tiles[i].reads = {{west, 0}, {west + 1, 1}};
    }
    EXPECT_DOUBLE_EQ(largestWindowBytes(plan), 50 + 4 * 50) << "50 bytes each square metre that is read";
    for (std::size_t i = 0; i < 4; ++i) plan.tiles[i].window = i;
    EXPECT_DOUBLE_EQ(largestWindowBytes(plan), 100);
}

TEST(FormatRanges, AsSchedulersTakeThem) {
    EXPECT_EQ(formatRanges({}), "");
    EXPECT_EQ(formatRanges({0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
}

/// A town in an indexed GeoPackage, and plans of it.
class TaskPlanTest : public testing::Test {
protected:
    TaskPlanTest() {
        City city = cityOf(randomBoxes(11, 10));
        city.frame = Frame({-73.98, 40.75});
        EXPECT_TRUE(writeCityGeoPackage(folder.path("town.gpkg"), city));
        request.files = {folder.path("town.gpkg").string()};
        request.settings.period.zone = "America/New_York";
        request.settings.period.stepMinutes = 20;
        request.settings.engine = "projected";
        request.settings.errorSample.receivers = 0;
        request.region = "city";
        request.tileCells = 64;
        request.task = {0.001, 1e9};
    }
    [[nodiscard]] TaskPlan plan() const {
        NoProgress progress;
        auto made = makeTaskPlan(request, progress, {});
        EXPECT_TRUE(made) << made.error().text();
        return *std::move(made);
    }
    [[nodiscard]] Result<TaskReport> run(const TaskPlan& plan, std::size_t task,
                                         const std::stop_token& stop = {}) const {
        NoProgress progress;
        return runTask(folder.path("plan"), plan, task, {request.reading, request.settings, request.subject},
                       progress, stop);
    }
    [[nodiscard]] Result<MergeReport> merge(const TaskPlan& plan) const {
        NoProgress progress;
        return mergeTiles(folder.path("plan"), plan, request.settings, {}, progress, {});
    }

    [[nodiscard]] Result<MergeReport> runAndMerge(const TaskPlan& plan) const {
        for (std::size_t task = 0; task < plan.taskCount; ++task)
            if (auto report = run(plan, task); !report) return tl::make_unexpected(report.error());
        return merge(plan);
    }
    /// Writes whole.tif, and by_month.tif if the request asks for months.
    [[nodiscard]] TiledStudy onOneMachine() const {
        NoProgress progress;
        const City city =
            readCity({request.files.begin(), request.files.end()}, request.reading, progress, {})
                .value()
                .city;
        StudySettings settings = request.settings;
        settings.region = makeRegionFromLocalBox(bounds(city));
        return runTiledStudy(city, {settings, 64}, folder.path("whole.tif"), progress, {}).value();
    }
    void expectEqualMaps(const TaskPlan& plan, const char* merged, const char* whole,
                         std::size_t bands) const {
        const Grid grid = plan.districts[0].tiles.whole;
        const auto a = readGeoTiff(folder.path(merged), grid).value();
        const auto b = readGeoTiff(folder.path(whole), grid).value();
        ASSERT_EQ(a.size(), bands);
        ASSERT_EQ(b.size(), bands);
        for (std::size_t band = 0; band < bands; ++band)
            EXPECT_EQ(std::memcmp(a[band].data(), b[band].data(), a[band].size() * sizeof(float)), 0) << band;
    }
    [[nodiscard]] std::string textOf(const char* file) const {
        std::ifstream stream(folder.path(file));
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    TemporaryFolder folder;
    TaskPlanRequest request;
};

TEST_F(TaskPlanTest, ComesBackFromItsFileToTheLastBit) {
    TaskPlan made = plan();
    EXPECT_TRUE(made.byWindow);
    made.arguments = {"--start=2026-03-21"};
    made.inputs = {{"town.gpkg", 7, "abc"}};
    std::filesystem::create_directories(folder.path("plan"));
    ASSERT_TRUE(writeTaskPlan(folder.path("plan"), made));
    const auto read = readTaskPlan(folder.path("plan"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->files, made.files);
    EXPECT_EQ(read->arguments, made.arguments);
    EXPECT_EQ(read->taskCount, made.taskCount);
    EXPECT_EQ(read->studyHash(0), made.studyHash(0));
    EXPECT_EQ(read->districts[0].region, made.districts[0].region);
    EXPECT_EQ(read->districts[0].frame, made.districts[0].frame);
    EXPECT_EQ(read->districts[0].tiles.whole, made.districts[0].tiles.whole);
    ASSERT_EQ(read->tiles.size(), made.tiles.size());
    for (std::size_t i = 0; i < made.tiles.size(); ++i) {
        EXPECT_EQ(read->tiles[i].reads, made.tiles[i].reads);
        EXPECT_EQ(read->tiles[i].contentHash, made.tiles[i].contentHash);
        EXPECT_EQ(read->tiles[i].seconds, made.tiles[i].seconds);
        EXPECT_EQ(read->tiles[i].memoryBytes, made.tiles[i].memoryBytes);
        EXPECT_EQ(read->tiles[i].readBytes, made.tiles[i].readBytes);
        EXPECT_EQ(read->tiles[i].window, made.tiles[i].window);
    }
}

TEST_F(TaskPlanTest, DamagedPlansAreRefused) {
    std::filesystem::create_directories(folder.path("plan"));
    EXPECT_THAT(readTaskPlan(folder.path("plan")).error().text(), HasSubstr("no plan"));
    for (const char* text : {"", "{", "[]", R"({"noonmark_task_plan":3})"}) {
        std::ofstream(folder.path("plan") / planFileName) << text;
        EXPECT_FALSE(readTaskPlan(folder.path("plan"))) << text;
    }
}

/// Whether a plan whose member at `pointer` is replaced is still read.
bool isReadWith(const std::filesystem::path& folder, const char* pointer, const nlohmann::json& value) {
    std::ifstream before(folder / planFileName);
    nlohmann::json json = nlohmann::json::parse(before);
    json[nlohmann::json::json_pointer(pointer)] = value;
    const auto other = folder / "other";
    std::filesystem::create_directories(other);
    std::ofstream(other / planFileName) << json.dump();
    return readTaskPlan(other).has_value();
}

TEST_F(TaskPlanTest, PlansOfStrangersAreChecked) {
    const auto there = folder.path("plan");
    std::filesystem::create_directories(there);
    ASSERT_TRUE(writeTaskPlan(there, plan()));
    EXPECT_TRUE(isReadWith(there, "/districts/0/name", "d-003-"));
    const std::vector<std::pair<const char*, nlohmann::json>> changes{
        {"/districts/0/name", "../../elsewhere-"},
        {"/districts/0/tile_cells", 2147483647},
        {"/districts/0/grid/3", 2147483647},
        {"/districts/0/grid/2", 1e300},
        {"/districts/0/origin/1", 91},
        {"/districts/0/region/polygons/0/0", {0, 0, 1, 1}},
        {"/districts/0/region/polygons/0/0/0", 1e300},
        {"/tiles/0/3/0", 1e300},
        {"/tiles/0/1", 7},
        {"/tiles/0/2", 1000000},
        {"/tiles/0/0", 1000000},
        {"/tiles/0/9", 1},
        {"/tiles/1/9", 1},
        {"/file_boxes", nlohmann::json::array()},
        {"/file_boxes/0", {0, 0, 1}},
        {"/noonmark_task_plan", 2},
        {"/noonmark_task_plan", 4},
        {"/task_count", 1000000000000}};
    for (const auto& [pointer, value] : changes) EXPECT_FALSE(isReadWith(there, pointer, value)) << pointer;
    EXPECT_FALSE(isReadWith(there, "/task_count", plan().taskCount + 1)) << "a task without tiles";
}

TEST_F(TaskPlanTest, TasksTogetherEqualOneStudyToTheLastBit) {
    const TaskPlan made = plan();
    ASSERT_GT(made.taskCount, 4U);
    const auto merged = runAndMerge(made);
    ASSERT_TRUE(merged) << merged.error().text();
    const TiledStudy whole = onOneMachine();
    EXPECT_EQ(made.districts[0].region.polygons, whole.study.settings.region.polygons);
    EXPECT_EQ(made.districts[0].frame, whole.study.city.frame);
    expectEqualMaps(made, "plan/merged/shadow.tif", "whole.tif", 2);
    EXPECT_EQ(merged->statistics.receivers, whole.study.statistics.receivers);
}

TEST_F(TaskPlanTest, ATaskOfSeveralWindowsEqualsOneStudyToTheLastBit) {
    request.task = {1e6, 1};
    const TaskPlan made = plan();
    ASSERT_EQ(made.taskCount, 1U);
    ASSERT_EQ(made.tiles.back().window + 1, made.tiles.size());
    ASSERT_TRUE(runAndMerge(made));
    EXPECT_EQ(onOneMachine().plan.count(), made.tiles.size());
    expectEqualMaps(made, "plan/merged/shadow.tif", "whole.tif", 2);
}

// Three files of towers, 400 m apart from west to east; each may have a terrain of its own.
std::vector<std::string> writeCityJsonTiles(const TemporaryFolder& folder, bool withTerrain = false) {
    std::vector<std::string> files;
    for (int tile = 0; tile < 3; ++tile) {
        CityJsonMaker maker;
        for (int i = 0; i < 4; ++i) {
            const double west = 400.0 * tile + 30 * i, south = 25.0 * i;
            maker.addBuilding("tower " + std::to_string(i),
                              maker.boxSolid({west, south, 0}, {west + 12, south + 15, 20.0 + 10 * i}));
        }
        if (withTerrain) {
            const int first = maker.addBox({400.0 * tile - 50, -50, -0.5}, {400.0 * tile + 150, 150, 0});
            const Json faces{{{first, first + 1, first + 3}}, {{first, first + 3, first + 2}}};
            maker.addBuilding("ground", {{"type", "CompositeSurface"}, {"lod", "1"}, {"boundaries", faces}},
                              "TINRelief");
        }
        const std::string name = "tile " + std::to_string(tile) + ".city.json";
        files.push_back(folder.file(name, maker.document().dump()).string());
    }
    return files;
}

TEST_F(TaskPlanTest, TasksOpenOnlyTheCityJsonFilesThatTheirWindowsTouch) {
    request.files = writeCityJsonTiles(folder);
    request.reading.terrainFromBases = TerrainFromBases::never;
    request.settings.period.zone = "Europe/Amsterdam";
    const TaskPlan made = plan();
    EXPECT_TRUE(made.byWindow);
    ASSERT_EQ(made.fileBoxes.size(), 3U);
    EXPECT_LT(made.fileBoxes[0].eastDeg, made.fileBoxes[1].westDeg);
    ASSERT_TRUE(runAndMerge(made));
    EXPECT_EQ(onOneMachine().plan.count(), made.tiles.size());
    expectEqualMaps(made, "plan/merged/shadow.tif", "whole.tif", 2);

    std::filesystem::remove_all(folder.path("plan"));
    std::ofstream(request.files[2]) << "no city at all";
    TaskPlan withoutCheck = made;
    withoutCheck.inputs.clear();
    EXPECT_TRUE(run(withoutCheck, 0)) << "the westernmost tile does not need the easternmost file";
    EXPECT_FALSE(run(withoutCheck, made.taskCount - 1));
}

TEST_F(TaskPlanTest, CityJsonWithATerrainIsReadWholeByEveryTask) {
    request.files = writeCityJsonTiles(folder, true);
    request.reading.terrainFromBases = TerrainFromBases::never;
    request.settings.period.zone = "Europe/Amsterdam";
    const TaskPlan made = plan();
    EXPECT_FALSE(made.byWindow);
    EXPECT_FALSE(made.districts[0].terrainHash.empty());
}

TEST_F(TaskPlanTest, MonthsEqualThoseOfOneMachineToTheLastBit) {
    request.settings.byMonth = true;
    request.settings.period.days = 40;
    request.settings.period.stepMinutes = 60;
    const TaskPlan made = plan();
    ASSERT_TRUE(runAndMerge(made));
    const TiledStudy whole = onOneMachine();
    ASSERT_EQ(whole.months.size(), 2U);
    expectEqualMaps(made, "plan/merged/shadow.tif", "whole.tif", 2);
    expectEqualMaps(made, "plan/merged/by_month.tif", "by_month.tif", 2);
    EXPECT_EQ(textOf("plan/merged/by_month.csv"), monthsCsv(whole.months, {}));
    // The tile's file has the two bands of shadow.tif before those of the months.
    EXPECT_THAT(textOf("plan/merged/by_month.vrt"), HasSubstr("<SourceBand>4</SourceBand>"));
    EXPECT_THAT(textOf("plan/merged/by_month.vrt"), Not(HasSubstr("<SourceBand>1</SourceBand>")));
    EXPECT_THAT(textOf("plan/merged/item.json"), HasSubstr("./by_month.tif"));
}

TEST_F(TaskPlanTest, WhatIsDoneAndWholeIsNotComputedAgain) {
    const TaskPlan made = plan();
    ASSERT_EQ(run(made, 0).value().computed, made.tilesOf(0).size());
    EXPECT_EQ(run(made, 0).value().computed, 0U);
    for (const auto& entry : std::filesystem::directory_iterator(taskFolder(folder.path("plan"), 0)))
        if (entry.path().extension() == ".tif") {
            std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
            file.seekp(-1, std::ios::end);
            file.put('?');  // same size, another content
        }
    EXPECT_GT(run(made, 0).value().computed, 0U);
    EXPECT_EQ(run(made, 0).value().computed, 0U);
}

TEST_F(TaskPlanTest, AKillInTheMiddleOfAWriteLosesOneTile) {
    request.task = {1e6, 1e12};
    const TaskPlan made = plan();
    ASSERT_EQ(made.taskCount, 1U);
    ASSERT_TRUE(run(made, 0));
    const auto tasks = taskFolder(folder.path("plan"), 0);
    std::filesystem::resize_file(tasks / "journal.jsonl",
                                 std::filesystem::file_size(tasks / "journal.jsonl") - 5);
    std::ofstream(tasks / ".tile-00003.1234-0.tif") << "half a tile";
    const auto status = findStatus(folder.path("plan"), made);
    ASSERT_TRUE(status);
    EXPECT_EQ(status->doneTiles + 1, status->allTiles);
    EXPECT_FALSE(merge(made));
    EXPECT_EQ(run(made, 0).value().computed, 1U);
    EXPECT_TRUE(merge(made));
}

TEST_F(TaskPlanTest, ErrorsThatMayPassAreToldFromThoseThatStay) {
    const TaskPlan made = plan();
    const auto unknown = run(made, 100000);
    ASSERT_FALSE(unknown);
    EXPECT_FALSE(isRetryable(unknown.error()));
    std::stop_source stopped;
    stopped.request_stop();
    const auto cancelledRun = run(made, 0, stopped.get_token());
    ASSERT_FALSE(cancelledRun);
    EXPECT_TRUE(isRetryable(cancelledRun.error()));
    const auto other =
        TileJournal::open(taskFolder(folder.path("plan"), 1), made.studyHash(0), made.districts[0].tiles);
    const auto busy = run(made, 1);
    ASSERT_FALSE(busy);
    EXPECT_TRUE(isRetryable(busy.error())) << busy.error().text();
    request.settings.period.hours = 3;
    const auto changed = run(made, 0);
    ASSERT_FALSE(changed);
    EXPECT_FALSE(isRetryable(changed.error()));
}

TEST_F(TaskPlanTest, AChangeInOnePlaceChangesOnlyTheTilesThatReadIt) {
    const TaskPlan before = plan();
    City city = cityOf(randomBoxes(11, 10));
    city.frame = Frame({-73.98, 40.75});
    Building building = *city.buildings.front();
    building.parts.front().topM += 1;
    city.buildings.front() = std::make_shared<const Building>(building);
    std::filesystem::remove(request.files[0]);
    ASSERT_TRUE(writeCityGeoPackage(request.files[0], city));
    const TaskPlan after = plan();
    ASSERT_EQ(before.tiles.size(), after.tiles.size());
    std::map<std::size_t, std::string> hashes;
    for (const PlannedTile& tile : before.tiles) hashes[tile.number] = tile.contentHash;
    std::size_t changed = 0;
    for (const PlannedTile& tile : after.tiles) changed += hashes[tile.number] == tile.contentHash ? 0 : 1;
    EXPECT_GT(changed, 0U);
}

TEST_F(TaskPlanTest, RefusesWhatNeedsTheWholeCity) {
    NoProgress progress;
    request.reading.terrainFromBases = TerrainFromBases::always;
    EXPECT_THAT(makeTaskPlan(request, progress, {}).error().text(), HasSubstr("whole city"));
    request.reading = {};
    request.settings.contributions = true;
    EXPECT_FALSE(makeTaskPlan(request, progress, {}));
    request.settings.contributions = false;
    request.settings.byMonth = true;
    request.settings.engine = "ray";
    EXPECT_THAT(makeTaskPlan(request, progress, {}).error().text(), HasSubstr("Choose one of"));
}

}  // namespace
}  // namespace noonmark
