#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/city/trees/tree.h"
#include "core/engines/shade_trees.h"
#include "core/io/write_raster.h"
#include "core/study/tile_tasks/merge/merge_tiles.h"
#include "core/study/tile_tasks/plan/make_task_plan.h"
#include "core/study/tile_tasks/run_task.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/scenario.h"
#include "scenarios/tile_subjects.h"
#include "scenarios/weights/score.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using namespace std::chrono;
using namespace std::chrono_literals;
using testing::HasSubstr;
using Bands = std::vector<std::vector<float>>;

std::size_t differentCells(const std::vector<float>& a, const std::vector<float>& b) {
    if (a.size() != b.size()) return std::max(a.size(), b.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i]))) ++count;
    return count;
}

/// Three houses, and a scenario with a tower and without the last house, in twelve tiles.
class TileSubjects : public testing::Test {
protected:
    TileSubjects() {
        before = std::make_shared<const City>(threeHouses());
        const std::vector<Edit> edits{AddBuilding{shared(house("t", box(5, 40, 25, 60), 60))}, Demolish{"c"}};
        after = std::make_shared<const City>(applyEdits(*before, edits).value().city);
        settings.receivers.cellM = 1;
        settings.engine = "projected";
        settings.errorSample.receivers = 0;
        settings.period = {.hours = 6, .stepMinutes = 20, .zone = "America/New_York"};
    }

    [[nodiscard]] Result<TaskPlan> plan(const TileSubject& subject) const {
        TaskPlanRequest request{.files = {"project"}, .settings = settings, .subject = &subject};
        request.tileCells = 64;
        request.task = {0.001, 1e9};
        NoProgress progress;
        return makeTaskPlan(request, progress, {});
    }
    [[nodiscard]] Result<TaskReport> run(const TaskPlan& plan, std::size_t task,
                                         const TileSubject& subject) const {
        NoProgress progress;
        return runTask(folder.path("plan"), plan, task, {{}, settings, &subject}, progress, {});
    }
    /// All tiles, one map for each.
    [[nodiscard]] MergeReport merged(const TileSubject& subject, std::vector<TileMap> maps) const {
        const TaskPlan made = plan(subject).value();
        EXPECT_EQ(made.tiles.size(), 12U);
        EXPECT_GT(made.taskCount, 4U);
        for (std::size_t task = 0; task < made.taskCount; ++task)
            EXPECT_EQ(run(made, task, subject).value().computed, made.tilesOf(task).size());
        NoProgress progress;
        return mergeTiles(folder.path("plan"), made, settings, {.maps = std::move(maps)}, progress, {})
            .value();
    }
    [[nodiscard]] Bands read(const std::string& map, const Grid& grid) const {
        return readGeoTiff(folder.path("plan/merged/" + map + ".tif"), grid).value();
    }
    [[nodiscard]] StudySettings whole() const {
        StudySettings whole = settings;
        whole.region = region;
        return whole;
    }

    TemporaryFolder folder;
    std::shared_ptr<const City> before, after;
    Region region = makeRegionFromLocalBox({{-60, -40}, {160, 120}});
    StudySettings settings;
};

TEST_F(TileSubjects, ImpactEqualsThatOfOnePieceToTheLastBit) {
    const MergeReport report = merged(makeImpactSubject({before, after, region}), listImpactMaps());
    NoProgress progress;
    const ImpactStudy one = runImpact(*before, *after, {whole()}, progress, {}).value();
    const Grid& grid = one.total.grid;
    const Bands impact = read("impact", grid), old = read("before", grid), now = read("after", grid);
    for (const Bands* bands : {&impact, &old, &now}) ASSERT_EQ(bands->size(), 2U);
    EXPECT_EQ(differentCells(impact[0], one.total.grossMin), 0U);
    EXPECT_EQ(differentCells(impact[1], one.total.continuousMin), 0U);
    EXPECT_EQ(differentCells(old[0], one.before.grossMin), 0U);
    EXPECT_EQ(differentCells(old[1], one.before.continuousMin), 0U);
    EXPECT_EQ(differentCells(now[0], one.after.grossMin), 0U);
    EXPECT_EQ(differentCells(now[1], one.after.continuousMin), 0U);

    const ImpactFigures figures = computeFigures(one.total, 0);
    EXPECT_GT(figures.gross.anyMoreShadowM2, 1000);
    EXPECT_NEAR(report.figures.at("touched_m2"), figures.gross.anyMoreShadowM2, 1e-6);
    EXPECT_NEAR(report.figures.at("eased_m2"), figures.gross.anyLessShadowM2, 1e-6);
    EXPECT_NEAR(report.figures.at("gained_over_30_min_m2"), computeFigures(one.total).gross.moreShadowM2,
                1e-6);
    EXPECT_NEAR(report.figures.at("shadow_area_change_m2"), figures.shadowAreaChangeM2, 1e-6);
    EXPECT_EQ(report.figures.at("became_building_m2"), 400);
    EXPECT_EQ(report.figures.at("became_ground_m2"), 100);
    using testing::Key;
    EXPECT_THAT(report.figures,
                testing::ElementsAre(Key("became_building_m2"), Key("became_ground_m2"), Key("eased_m2"),
                                     Key("gained_over_30_min_m2"), Key("lost_over_30_min_m2"),
                                     Key("shadow_area_change_m2"), Key("touched_m2")));
    EXPECT_EQ(report.statistics.receivers, computeStatistics(one.after).receivers);
}

TEST_F(TileSubjects, TheShadowOfAScenarioEqualsItsStudy) {
    EXPECT_TRUE(merged({.key = "study", .cities = {after}, .region = region}, {}).figures.empty());
    NoProgress progress;
    const Study one = runStudy(*after, whole(), progress, {}).value();
    const Bands shadow = read("shadow", one.field.grid);
    ASSERT_EQ(shadow.size(), 2U);
    EXPECT_EQ(differentCells(shadow[0], one.field.grossMin), 0U);
    EXPECT_EQ(differentCells(shadow[1], one.field.continuousMin), 0U);
}

TEST_F(TileSubjects, ScoreEqualsThatOfOnePieceToTheLastBit) {
    settings.period = {.start = 2026y / January / 1,
                       .days = 365,
                       .from = 8h,
                       .hours = 8,
                       .stepMinutes = 120,
                       .zone = "America/New_York"};
    const TimeWeights weights = makeMonthlyWeights();
    const MergeReport report = merged(makeScoreSubject({after, region, weights}), listScoreMaps());
    NoProgress progress;
    const Score one = runScore(*after, whole(), weights, progress, {}).value();
    const Bands score = read("score", one.grid);
    ASSERT_EQ(score.size(), 1U);
    EXPECT_EQ(differentCells(score[0], one.score), 0U);
    EXPECT_NEAR(report.figures.at("score_m2"), one.scoreM2, std::abs(one.scoreM2) * 1e-9);
    EXPECT_NEAR(report.figures.at("score_m2_2026-07"), one.months[6].scoreM2, 1e-6);
    EXPECT_NEAR(report.figures.at("shadow_area_m2_2026-12"), one.months[11].shadowAreaM2, 1e-6);
    std::ifstream stream(folder.path("plan/merged/statistics.json"));
    const auto json = nlohmann::json::parse(stream);
    EXPECT_TRUE(json["mean_gross_min"].is_null());  // a score has no minutes of shadow
    EXPECT_NEAR(json["figures"]["score_m2"], one.scoreM2, std::abs(one.scoreM2) * 1e-9);
}

/// The same with trees in the south-west, of which the scenario fells one and plants another.
class TileSubjectsWithTrees : public TileSubjects {
protected:
    TileSubjectsWithTrees() {
        settings.engine = "ray";
        City first = *before, second = *after;
        first.trees = planted({{-40, -20}, {-20, 0}});
        second.trees = planted({{-40, -20}, {-25, 30}});
        before = std::make_shared<const City>(std::move(first));
        after = std::make_shared<const City>(std::move(second));
    }
    static std::shared_ptr<const Trees> planted(const std::vector<glm::dvec2>& places) {
        Trees trees{.trees = {}, .leafDays = {106, 320}};
        for (const glm::dvec2 place : places)
            trees.trees.push_back({.place = place,
                                   .heightM = 9,
                                   .crownBaseM = 2,
                                   .crownDiameterM = 8,
                                   .leafOnTransmissivity = 0.1F,
                                   .leafOffTransmissivity = 0.7F});
        return std::make_shared<const Trees>(std::move(trees));
    }
};

TEST_F(TileSubjectsWithTrees, ImpactEqualsThatOfOnePieceToTheLastBit) {
    const MergeReport report = merged(makeImpactSubject({before, after, region}), listImpactMaps());
    NoProgress progress;
    const ImpactStudy one = runImpact(*before, *after, {whole()}, progress, {}).value();
    ASSERT_EQ(one.withTrees.size(), 2U);
    const Grid& grid = one.total.grid;
    EXPECT_EQ(differentCells(read("impact", grid)[0], one.total.grossMin), 0U) << "without trees";
    for (const ShadeImpact& with : one.withTrees) {
        const std::string suffix = suffixOf(with.column);
        const Bands impact = read("impact" + suffix, grid), old = read("before" + suffix, grid),
                    now = read("after" + suffix, grid);
        EXPECT_EQ(differentCells(impact[0], with.impact.grossMin), 0U);
        EXPECT_EQ(differentCells(impact[1], with.impact.continuousMin), 0U);
        EXPECT_EQ(differentCells(old[0], fieldOfColumn(one.before, with.column).grossMin), 0U);
        EXPECT_EQ(differentCells(now[1], fieldOfColumn(one.after, with.column).continuousMin), 0U);
        const ImpactFigures figures = computeFigures(with.impact, 0);
        EXPECT_GT(figures.gross.anyLessShadowM2, 50) << "where the tree stood";
        EXPECT_NEAR(report.figures.at("touched_m2" + suffix), figures.gross.anyMoreShadowM2, 1e-6);
        EXPECT_NEAR(report.figures.at("eased_m2" + suffix), figures.gross.anyLessShadowM2, 1e-6);
        EXPECT_NEAR(report.figures.at("shadow_area_change_m2" + suffix), figures.shadowAreaChangeM2, 1e-6);
    }
    EXPECT_TRUE(report.warnings.empty());
    EXPECT_FALSE(report.figures.contains("became_building_m2_seasonal"));
    EXPECT_EQ(report.figures.size(), 7 + 2 * 5U);
}

TEST_F(TileSubjectsWithTrees, AreLeftOutWhereTheyAreNotWanted) {
    settings.trees = TreeColumns::without;
    const MergeReport report = merged(makeImpactSubject({before, after, region}), listImpactMaps());
    EXPECT_FALSE(report.figures.contains("touched_m2_seasonal"));
    EXPECT_FALSE(std::filesystem::exists(folder.path("plan/merged/impact_seasonal.tif")));
}

TEST_F(TileSubjectsWithTrees, ScoreEqualsThatOfOnePieceToTheLastBit) {
    settings.period = {.start = 2026y / January / 1,
                       .days = 365,
                       .from = 8h,
                       .hours = 8,
                       .stepMinutes = 240,
                       .zone = "America/New_York"};
    const TimeWeights weights = makeMonthlyWeights();
    const MergeReport report = merged(makeScoreSubject({after, region, weights}), listScoreMaps());
    NoProgress progress;
    const Score one = runScore(*after, whole(), weights, progress, {}).value();
    ASSERT_EQ(one.withTrees.size(), 2U);
    EXPECT_EQ(differentCells(read("score", one.grid)[0], one.score), 0U);
    for (const ShadedScore& with : one.withTrees) {
        const std::string suffix = suffixOf(with.column);
        EXPECT_EQ(differentCells(read("score" + suffix, one.grid)[0], with.score), 0U) << suffix;
        EXPECT_NEAR(report.figures.at("score_m2" + suffix), with.scoreM2, std::abs(with.scoreM2) * 1e-9);
        EXPECT_NEAR(report.figures.at("score_m2_2026-07" + suffix), with.months[6].scoreM2, 1e-6);
        EXPECT_NE(with.scoreM2, one.scoreM2);
    }
}

TEST_F(TileSubjects, ATaskOfOtherScenariosIsRefused) {
    const TileSubject subject = makeImpactSubject({before, after, region});
    const TaskPlan made = plan(subject).value();
    EXPECT_THAT(run(made, 0, makeImpactSubject({after, before, region})).error().text(),
                HasSubstr("other scenarios"));
    EXPECT_NE(made.studyHash(0), plan(makeImpactSubject({after, before, region})).value().studyHash(0));
    TimeWeights weights = makeMonthlyWeights();
    const std::string hash = plan(makeScoreSubject({after, region, weights})).value().studyHash(0);
    weights.intervals[3].weight = 0.25;
    EXPECT_NE(hash, plan(makeScoreSubject({after, region, weights})).value().studyHash(0));
}

TEST_F(TileSubjects, WhatIsDoneIsNotComputedAgain) {
    const TileSubject subject = makeImpactSubject({before, after, region});
    std::ofstream(folder.path("project")) << "a project";
    TaskPlan made = plan(subject).value();
    made.inputs = {describeInputFile(folder.path("project")).value()};
    ASSERT_EQ(run(made, 2, subject).value().computed, made.tilesOf(2).size());
    EXPECT_EQ(run(made, 2, subject).value().computed, 0U);
    std::ofstream(folder.path("project")) << "A project";  // as long, with other content
    EXPECT_THAT(run(made, 3, subject).error().text(), HasSubstr("changed"));
}

TEST_F(TileSubjects, PlacesOfAScoreAreRefused) {
    const TileSubject subject = makeScoreSubject({after, region, makeMonthlyWeights()});
    const TaskPlan made = plan(subject).value();
    for (std::size_t task = 0; task < made.taskCount; ++task) ASSERT_TRUE(run(made, task, subject));
    const auto places =
        folder.file("places.geojson",
                    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"name":"Here"},
            "geometry":{"type":"Polygon","coordinates":[[[-73.9701,40.76],[-73.97,40.76],[-73.97,40.7601],
            [-73.9701,40.76]]]}}]})");
    NoProgress progress;
    const MergeSettings merge{.places = places, .maps = listScoreMaps()};
    EXPECT_THAT(mergeTiles(folder.path("plan"), made, settings, merge, progress, {}).error().text(),
                HasSubstr("have none"));
}

}  // namespace
}  // namespace noonmark::tests
