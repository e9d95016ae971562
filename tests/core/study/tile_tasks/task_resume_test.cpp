#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/study/tile_tasks/run_task.h"
#include "tests/core/study/tile_tasks/task_plan_fixture.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

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

TEST_F(TaskPlanTest, FoldersThatLeadElsewhereAreRefused) {
    const TaskPlan made = plan();
    const auto planned = folder.path("plan"), elsewhere = folder.path("elsewhere");
    std::filesystem::create_directories(planned);
    std::filesystem::create_directories(elsewhere / "00000");
    std::filesystem::create_directory_symlink(elsewhere, planned / "tasks");
    EXPECT_THAT(run(made, 0).error().text(), HasSubstr("tasks: This is a link"));
    EXPECT_FALSE(findStatus(planned, made));
    std::filesystem::remove(planned / "tasks");
    std::filesystem::create_directories(planned / "tasks");
    std::filesystem::create_directory_symlink(elsewhere, planned / "tasks/00000");
    EXPECT_THAT(run(made, 0).error().text(), HasSubstr("00000: This is a link"));
    std::filesystem::remove(planned / "tasks/00000");
    std::filesystem::create_directories(planned / "tasks/00000");
    std::filesystem::create_symlink(elsewhere / "planted", planned / "tasks/00000/journal.jsonl");
    EXPECT_THAT(run(made, 0).error().text(), HasSubstr("journal.jsonl: This is a link"));
    std::filesystem::remove_all(planned / "tasks");
    ASSERT_TRUE(run(made, 0));
    std::filesystem::create_directory_symlink(elsewhere, planned / "merged");
    EXPECT_THAT(merge(made).error().text(), HasSubstr("Missing: 15 of 16 tiles"));
    for (std::size_t task = 1; task < made.taskCount; ++task) ASSERT_TRUE(run(made, task));
    EXPECT_THAT(merge(made).error().text(), HasSubstr("merged: This is a link"));
    EXPECT_TRUE(std::filesystem::is_empty(elsewhere / "00000"));
    EXPECT_FALSE(std::filesystem::exists(elsewhere / "planted"));
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
