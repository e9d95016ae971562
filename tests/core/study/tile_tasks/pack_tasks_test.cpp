#include <gtest/gtest.h>

#include "core/study/tile_tasks/plan/make_task_plan.h"
#include "core/study/tile_tasks/run_task.h"

namespace noonmark {
namespace {

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
    plan.byExtent = true;
    plan.tiles[2].reads = {{2, 2}, {3, 3}};  // with the others 9 m2: 0.5 GB + 9 x 0.5 GB
    plan.tiles[3].reads = {{2, 2}, {3, 3}};
    EXPECT_EQ(packTasks(plan, {1000, 2e9}), 1U);
    std::vector<std::size_t> windows;
    for (const PlannedTile& tile : plan.tiles) windows.push_back(tile.window);
    EXPECT_EQ(windows, (std::vector<std::size_t>{0, 0, 1, 1}));
}

TEST(PackTasks, EveryTaskBeginsItsWindowsAnew) {
    TaskPlan plan = planOf(2, 10, 1e9);
    plan.byExtent = true;
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
    EXPECT_DOUBLE_EQ(largestExtentBytes(TaskPlan()), 0);
    packTasks(plan, {1e6, 1e9});
    EXPECT_DOUBLE_EQ(largestExtentBytes(plan), 100) << "all halos are the same square metre";
    for (std::size_t i = 0; i < 4; ++i) {
        const auto west = float(i);
        plan.tiles[i].reads = {{west, 0}, {west + 1, 1}};
    }
    EXPECT_DOUBLE_EQ(largestExtentBytes(plan), 50 + 4 * 50) << "50 bytes each square metre that is read";
    for (std::size_t i = 0; i < 4; ++i) plan.tiles[i].window = i;
    EXPECT_DOUBLE_EQ(largestExtentBytes(plan), 100);
}

TEST(FormatRanges, AsSchedulersTakeThem) {
    EXPECT_EQ(formatRanges({}), "");
    EXPECT_EQ(formatRanges({0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
}

}  // namespace
}  // namespace noonmark
