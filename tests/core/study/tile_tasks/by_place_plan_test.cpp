#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/write_city.h"
#include "core/study/elements/element_tables.h"
#include "core/study/tile_tasks/merge/merge_tiles.h"
#include "core/study/tile_tasks/plan/make_task_plan.h"
#include "core/study/tile_tasks/run_task.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

const Frame placesFrame({-73.98, 40.75});

nlohmann::json boxFeature(const std::string& name, glm::dvec2 low, glm::dvec2 high) {
    nlohmann::json ring = nlohmann::json::array();
    for (const glm::dvec2 corner : {low, {high.x, low.y}, high, {low.x, high.y}, low}) {
        const LonLat at = placesFrame.lonLatFromLocal(corner);
        ring.push_back({at.lonDeg, at.latDeg});
    }
    return {{"type", "Feature"},
            {"properties", {{"name", name}}},
            {"geometry", {{"type", "Polygon"}, {"coordinates", {ring}}}}};
}

/// Places in a town of boxes: across the borders of tiles, so small that they have cells of their own, one
/// over the other, far outside, and under a building.
class ByPlacePlan : public testing::TestWithParam<const char*> {
protected:
    ByPlacePlan() {
        City city = cityOf(randomBoxes(11, 10));
        city.buildings.push_back(cityOf({{{300, 300, 0}, {340, 340, 30}}}).buildings.front());
        city.frame = placesFrame;
        EXPECT_TRUE(writeCityGeoPackage(folder.path("town.gpkg"), city));
        const nlohmann::json places{
            {"type", "FeatureCollection"},
            {"features",
             {boxFeature("Green", {20.5, 22.25}, {45, 40}), boxFeature("Long Meadow", {30, 20}, {165.5, 170}),
              boxFeature("Strip", {-40, 63.5}, {190, 66}), boxFeature("Corner", {62, 62}, {66, 66}),
              boxFeature("Cellar", {305, 305}, {330, 330}),
              boxFeature("Far Field", {500, 500}, {520, 530})}}};
        byPlace.places = folder.file("places.geojson", places.dump());
        byPlace.cities = {"Existing"};
        byPlace.settings.dates = {std::chrono::year(2026) / 12 / 21};
        request.files = {folder.path("town.gpkg").string()};
        request.settings.engine = GetParam();
        request.settings.receivers.cellM = 2;
        request.settings.errorSample.receivers = 20;
        request.settings.period = {.start = std::chrono::year(2026) / 2 / 20,
                                   .days = 20,
                                   .stepMinutes = 10,
                                   .window = SolarHours{},
                                   .zone = "America/New_York"};
        request.region = "city";
        request.tileCells = 64;
        request.task = {0.001, 1e9};
        request.byPlace = &byPlace;
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
    void runAll(const TaskPlan& plan) const {
        for (std::size_t task = 0; task < plan.taskCount; ++task) {
            const auto ran = run(plan, task);
            ASSERT_TRUE(ran) << ran.error().text();
        }
    }
    [[nodiscard]] Result<MergedSun> merge(const TaskPlan& plan, bool partial = false) const {
        NoProgress progress;
        return mergeSunByPlace(folder.path("plan"), plan, byPlace, request.settings,
                               {City{.frame = plan.districts.front().frame}}, partial, progress, {});
    }
    /// The same places measured at once, in a city that was read whole.
    [[nodiscard]] SunByPlace onOneMachine() const {
        NoProgress progress;
        const City city = readCity({request.files.front()}, request.reading, progress, {}).value().city;
        SunByPlaceSettings settings = byPlace.settings;
        settings.study = request.settings;
        return runSunByPlace(city, readPlaces(byPlace, city.frame, progress, {}).value(), settings, progress,
                             {})
            .value();
    }

    TemporaryFolder folder;
    ByPlaceRequest byPlace;
    TaskPlanRequest request;
};
INSTANTIATE_TEST_SUITE_P(Engines, ByPlacePlan, testing::Values("horizon", "projected"));

// The share of a cell in a place is clipped in the coordinates of the grid, which begins at other places.
void expectClose(double one, double other) { EXPECT_NEAR(one, other, 1e-9 * std::max(1.0, std::abs(other))); }

TEST_P(ByPlacePlan, EqualsThePlacesMeasuredAtOnceToTheLastDigit) {
    const TaskPlan made = plan();
    EXPECT_GT(made.tiles.size(), 2U);
    runAll(made);
    const auto merged = merge(made);
    ASSERT_TRUE(merged) << merged.error().text();
    const SunByPlace whole = onOneMachine();
    const SunByPlace& tiled = merged->sun.baseline;
    ASSERT_EQ(tiled.places, whole.places);
    EXPECT_EQ(toCsv(makeTable(tiled)), toCsv(makeTable(whole)));
    for (std::size_t i = 0; i < whole.sun.size(); ++i) {
        const SunOfPlace &a = tiled.sun[i], &b = whole.sun[i];
        EXPECT_EQ(a.cells, b.cells) << whole.places[i].name;
        EXPECT_EQ(a.remarks, b.remarks);
        if (b.cells == 0) continue;
        for (const Figure& figure : sunOfPlaceFigures().rows()) expectClose(figure.get(&a), figure.get(&b));
        ASSERT_EQ(a.monthHours.size(), 2U);
        for (std::size_t month = 0; month < 2; ++month) expectClose(a.monthHours[month], b.monthHours[month]);
        ASSERT_EQ(a.belowShare.size(), 1U);
        expectClose(a.belowShare[0], b.belowShare[0]);
        expectClose(a.dateHours[0], b.dateHours[0]);
    }
    EXPECT_LT(tiled.sun[1].minHours, tiled.sun[1].maxHours) << "shadow is there to be measured";
    EXPECT_EQ(tiled.sun[4].status, PlaceStatus::builtOver);
    EXPECT_EQ(tiled.possibleHours, whole.possibleHours);
    EXPECT_EQ(tiled.months, whole.months);
}

// Those of one machine are of a sample of its own: the same quantities, not the same numbers.
TEST_P(ByPlacePlan, EveryQuantityKeepsAnError) {
    const TaskPlan made = plan();
    runAll(made);
    const SunByPlace tiled = merge(made).value().sun.baseline, whole = onOneMachine();
    ASSERT_EQ(tiled.errors.size(), whole.errors.size());
    for (const ShownError& error : whole.errors)
        EXPECT_TRUE(std::ranges::any_of(tiled.errors, [&](const ShownError& one) {
            return one.facts.key == error.facts.key && one.of == error.of && one.count > 0;
        })) << error.facts.key;
    ASSERT_TRUE(tiled.error);
    EXPECT_GT(tiled.error->receivers, 20U) << "of several tiles";
}

TEST_P(ByPlacePlan, WhatIsDoneIsNotComputedAgainAndWhatIsMissingIsSaid) {
    const TaskPlan made = plan();
    ASSERT_TRUE(run(made, 0));
    EXPECT_EQ(run(made, 0).value().computed, 0U);
    EXPECT_THAT(merge(made).error().text(), HasSubstr("Missing: "));
    const MergedSun part = merge(made, true).value();
    EXPECT_GT(part.missingTiles, 0U);
    EXPECT_FALSE(part.sun.baseline.places.empty());
    EXPECT_TRUE(std::ranges::any_of(part.sun.baseline.warnings, [](const Warning& warning) {
        return warning.what == "a place of no finished tile";
    }));
}

// Tiles read trees of their own extent, and most of them have none.
TEST_P(ByPlacePlan, TreesCountInTheTilesThatTheyReach) {
    std::string trees = "tree_dbh,spc_latin,latitude,longitude\n";
    for (double x = 24; x < 60; x += 12) {
        const LonLat at = placesFrame.lonLatFromLocal({x, 30});
        trees += fmt::format("20,Pinus nigra,{:.7f},{:.7f}\n", at.latDeg, at.lonDeg);
    }
    request.reading.treeFiles = {folder.file("trees.csv", trees).string()};
    const TaskPlan made = plan();
    runAll(made);
    const auto merged = merge(made);
    ASSERT_TRUE(merged) << merged.error().text();
    const SunByPlace whole = onOneMachine();
    const SunByPlace& tiled = merged->sun.baseline;
    ASSERT_EQ(whole.withTrees.size(), 2U);
    ASSERT_EQ(tiled.withTrees.size(), 2U);
    EXPECT_EQ(tiled.treesHow, whole.treesHow);
    double taken = 0;
    for (std::size_t i = 0; i < whole.sun.size(); ++i) {
        if (whole.sun[i].cells == 0) continue;
        for (std::size_t column = 0; column < 2; ++column) {
            const SunOfPlace &a = tiled.withTrees[column].sun[i], &b = whole.withTrees[column].sun[i];
            for (const Figure& figure : sunFiguresWithTrees(whole.withTrees[column].column))
                EXPECT_NEAR(figure.get(&a), figure.get(&b), 1e-4) << whole.places[i].name;
            EXPECT_NEAR(a.dateHours[0], b.dateHours[0], 1e-4);
            taken = std::max(taken, whole.sun[i].meanHours - b.meanHours);
        }
    }
    EXPECT_GT(taken, 0.01) << "trees take something from some place";
}

TEST_P(ByPlacePlan, OtherPlacesOrThresholdsAreAnotherPlan) {
    const TaskPlan made = plan();
    byPlace.settings.enoughHours = 3;
    EXPECT_THAT(run(made, 0).error().text(), HasSubstr("other places"));
    byPlace.settings.enoughHours = SunByPlaceSettings{}.enoughHours;
    byPlace.placesHash = "of another file";
    EXPECT_THAT(run(made, 0).error().text(), HasSubstr("other places"));
}

}  // namespace
}  // namespace noonmark
