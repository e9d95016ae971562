#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "core/io/write_city.h"
#include "core/io/write_raster.h"
#include "core/study/tile_tasks/merge/merge_tiles.h"
#include "core/study/tile_tasks/plan/make_task_plan.h"
#include "core/study/tile_tasks/run_task.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::tests {

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

}  // namespace noonmark::tests
