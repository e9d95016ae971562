#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/io/write_city.h"
#include "core/study/tile_tasks/merge/merge_tiles.h"
#include "core/study/tile_tasks/plan/make_task_plan.h"
#include "core/study/tile_tasks/run_task.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;
using testing::StartsWith;

const Frame frame({-73.98, 40.75});

nlohmann::json ringAround(glm::dvec2 low, glm::dvec2 high) {
    nlohmann::json ring = nlohmann::json::array();
    for (const glm::dvec2 corner : {low, {high.x, low.y}, high, {low.x, high.y}, low}) {
        const LonLat at = frame.lonLatFromLocal(corner);
        ring.push_back({at.lonDeg, at.latDeg});
    }
    return {{"type", "Polygon"}, {"coordinates", {ring}}};
}

nlohmann::json featureOf(const std::string& name, glm::dvec2 low, glm::dvec2 high) {
    return {{"type", "Feature"}, {"properties", {{"name", name}}}, {"geometry", ringAround(low, high)}};
}

/// Three places in a town of boxes: one inside of a tile, one across four tiles, one far outside.
class TimelinePlan : public testing::Test {
protected:
    TimelinePlan() {
        City city = cityOf(randomBoxes(11, 10));
        city.frame = frame;
        EXPECT_TRUE(writeCityGeoPackage(folder.path("town.gpkg"), city));
        const nlohmann::json places{
            {"type", "FeatureCollection"},
            {"features",
             {featureOf("Green", {20, 22}, {45, 40}), featureOf("Long Meadow", {30, 20}, {165, 170}),
              featureOf("Far Field", {9000, 9000}, {9020, 9030})}}};
        timelines.places = folder.file("places.geojson", places.dump());
        timelines.labels.from = "Existing";
        request.files = {folder.path("town.gpkg").string()};
        request.settings.period.zone = "America/New_York";
        request.settings.period.stepMinutes = 20;
        request.region = "city";
        request.tileCells = 64;
        request.task = {0.001, 1e9};
        request.timelines = &timelines;
    }
    [[nodiscard]] TaskPlan plan() const {
        NoProgress progress;
        auto made = makeTaskPlan(request, progress, {});
        if (!made) throw std::runtime_error(made.error().text());
        return *std::move(made);
    }
    [[nodiscard]] Result<TaskReport> run(const TaskPlan& plan, std::size_t task) const {
        NoProgress progress;
        return runTask(folder.path("plan"), plan, task, request.question(), progress, {});
    }
    [[nodiscard]] Result<MergeReport> merge(const TaskPlan& plan, bool partial = false) const {
        NoProgress progress;
        return mergeTimelines(folder.path("plan"), plan, partial, progress, {});
    }
    [[nodiscard]] std::vector<nlohmann::json> mergedLines() const {
        std::ifstream stream(folder.path("plan/merged/timelines.jsonl"));
        std::vector<nlohmann::json> lines;
        for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
        return lines;
    }
    /// The same places measured at once, in a city that was read whole.
    [[nodiscard]] std::map<std::string, nlohmann::json> onOneMachine() const {
        NoProgress progress;
        const City city = readCity({request.files.front()}, request.reading, progress, {}).value().city;
        auto places =
            readPlaces(timelines.places, timelines.reading, city.frame, progress, {}).value().places;
        const auto engine = makeEngine(request.settings.engine).value();
        const PlaceStudy study = runPlaceStudy(city, nullptr, places,
                                               {.period = request.settings.period,
                                                .cellM = request.settings.receivers.cellM,
                                                .trees = request.settings.trees},
                                               *engine, progress, {})
                                     .value();
        std::map<std::string, nlohmann::json> lines;
        for (const PlaceTimeline& place : study.places)
            lines[place.place.name] =
                nlohmann::json::parse(timelineJson(study, place, timelines.labels).dump());
        return lines;
    }

    TemporaryFolder folder;
    TimelineRequest timelines;
    TaskPlanRequest request;
};

TEST_F(TimelinePlan, EqualsThePlacesMeasuredAtOnce) {
    const TaskPlan made = plan();
    EXPECT_EQ(made.tiles.size(), 2U) << "tiles without the middle of a place are not planned";
    for (std::size_t task = 0; task < made.taskCount; ++task) ASSERT_TRUE(run(made, task));
    const auto merged = merge(made);
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(merged->places, 2U);
    const auto expected = onOneMachine();
    for (const nlohmann::json& line : mergedLines()) {
        const nlohmann::json& own = expected.at(line.at("place"));
        EXPECT_GT(own.at("baseline").at("duration_min"), 0) << "shadow is there to be measured";
        EXPECT_EQ(line, own);
    }
}

TEST_F(TimelinePlan, CountsTreesAsThePlacesMeasuredAtOnce) {
    std::string trees = "tree_dbh,spc_latin,latitude,longitude\n";
    for (double x = 22; x < 44; x += 8) {
        const LonLat at = frame.lonLatFromLocal({x, 24});
        trees += std::to_string(16) + ",Tilia," + std::to_string(at.latDeg) + "," +
                 std::to_string(at.lonDeg) + "\n";
    }
    request.reading.treeFiles = {folder.file("trees.csv", trees).string()};
    const TaskPlan made = plan();
    for (std::size_t task = 0; task < made.taskCount; ++task) ASSERT_TRUE(run(made, task));
    ASSERT_TRUE(merge(made));
    const auto expected = onOneMachine();
    std::size_t shaded = 0;
    for (const nlohmann::json& line : mergedLines()) {
        EXPECT_EQ(line, expected.at(line.at("place")));
        shaded += line.at("baseline").contains("area_hours_m2h_seasonal") ? 1 : 0;
    }
    EXPECT_GT(shaded, 0U);
    std::ifstream table(folder.path("plan/merged/timelines.csv"));
    std::string heading;
    std::getline(table, heading);
    EXPECT_THAT(heading, HasSubstr(",baseline_area_hours_m2h_seasonal,"));
}

TEST_F(TimelinePlan, APlaceIsMeasuredWholeWhereItsBoxReachesBeyondTheRegion) {
    const LonLat low = frame.lonLatFromLocal({80, 60}), high = frame.lonLatFromLocal({140, 140});
    request.region = std::to_string(low.lonDeg) + "," + std::to_string(low.latDeg) + "," +
                     std::to_string(high.lonDeg) + "," + std::to_string(high.latDeg);
    const TaskPlan made = plan();
    for (std::size_t task = 0; task < made.taskCount; ++task) ASSERT_TRUE(run(made, task));
    ASSERT_TRUE(merge(made));
    const auto expected = onOneMachine();
    ASSERT_EQ(mergedLines().size(), 1U);
    const nlohmann::json line = mergedLines().front();
    EXPECT_EQ(line.at("place"), "Long Meadow");
    EXPECT_EQ(line.at("area_m2"), expected.at("Long Meadow").at("area_m2"));
}

TEST_F(TimelinePlan, TheTableHasARowForEachPlaceAndDay) {
    request.settings.period.days = 3;
    const TaskPlan made = plan();
    for (std::size_t task = 0; task < made.taskCount; ++task) ASSERT_TRUE(run(made, task));
    ASSERT_TRUE(merge(made));
    std::ifstream table(folder.path("plan/merged/timelines.csv"));
    std::vector<std::string> rows;
    for (std::string row; std::getline(table, row);) rows.push_back(row);
    ASSERT_EQ(rows.size(), 1U + 2 * 3);
    EXPECT_THAT(rows.front(), StartsWith("place,kind,source,day,area_m2,"));
    const auto fields = [](const std::string& row) {  // the source is quoted: "places.geojson, feature 0"
        return std::ranges::count(row, ',') - std::ranges::count(row, '"') / 2;
    };
    for (const std::string& row : rows) EXPECT_EQ(fields(row), fields(rows.front())) << row;
    EXPECT_FALSE(mergedLines().front().at("days").front().contains("steps"));
}

TEST_F(TimelinePlan, WhatIsDoneIsNotComputedAgainUnlessItsFileChanged) {
    const TaskPlan made = plan();
    ASSERT_TRUE(run(made, 0));
    EXPECT_EQ(run(made, 0).value().computed, 0U);
    for (const auto& entry : std::filesystem::directory_iterator(taskFolder(folder.path("plan"), 0)))
        if (entry.path().filename().string().starts_with("tile-")) {
            std::fstream file(entry.path(), std::ios::in | std::ios::out);
            file.put('?');  // same size, another content
        }
    EXPECT_EQ(run(made, 0).value().computed, made.tilesOf(0).size());
    EXPECT_THAT(merge(made).error().text(), HasSubstr("Missing: "));
    EXPECT_EQ(merge(made, true).value().places, made.tilesOf(0).size());
}

TEST_F(TimelinePlan, OtherPlacesAreAnotherPlan) {
    const TaskPlan made = plan();
    timelines.placesHash = "of another file";
    EXPECT_THAT(run(made, 0).error().text(), HasSubstr("other places"));
}

TEST_F(TimelinePlan, RefusesWhatHasNoTimelines) {
    NoProgress progress;
    request.settings.engine = "horizon";
    EXPECT_THAT(makeTaskPlan(request, progress, {}).error().text(), HasSubstr("timelines"));
    request.settings.engine = "auto";
    request.region = "-73.90,40.70,-73.89,40.71";
    EXPECT_THAT(makeTaskPlan(request, progress, {}).error().text(), HasSubstr("No place"));
}

TEST(TilePlanAt, FindsTheTileOfAPoint) {
    const TilePlan plan{{100, 200, 2, 10, 7}, 4};  // 3 x 2 tiles; 20 m x 14 m
    for (std::size_t tile = 0; tile < plan.count(); ++tile) {
        const Grid cells = plan.tile(tile);
        EXPECT_EQ(plan.tileAt({cells.westM, cells.southM}), tile);
        EXPECT_EQ(plan.tileAt({cells.eastM() - 1e-6, cells.northM() - 1e-6}), tile);
    }
    EXPECT_FALSE(plan.tileAt({99.9, 201}));
    EXPECT_FALSE(plan.tileAt({120, 201}));
    EXPECT_FALSE(plan.tileAt({101, 214}));
}

}  // namespace
}  // namespace noonmark
