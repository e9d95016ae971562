#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/styles/qgis_style.h"
#include "core/study/tile_tasks/run_task.h"
#include "core/study/tiles/tile_maps.h"
#include "tests/core/io/cityjson_fixtures.h"
#include "tests/core/io/terrain_files.h"
#include "tests/core/study/tile_tasks/task_plan_fixture.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;
using testing::Not;

TEST_F(TaskPlanTest, ComesBackFromItsFileToTheLastBit) {
    TaskPlan made = plan();
    EXPECT_TRUE(made.byExtent);
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
        {"/districts/0/grid/2", 1e-300},
        {"/files/0", "/dev/ptmx"},
        {"/inputs", {{{"path", "/dev/ptmx"}, {"bytes", 0}, {"sha256", ""}}}},
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
    EXPECT_EQ(textOf("plan/merged/shadow.qml"),
              rasterStyle(makeShadowScale(whole.study.statistics, whole.study.field.sunlitMinutesPerDay)));
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
    EXPECT_TRUE(made.byExtent);
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
    EXPECT_FALSE(made.byExtent);
    EXPECT_FALSE(made.districts[0].terrainHash.empty());
}

// A tower and a block, 30 and 12 m high, on ground that rises to the north.
double slope(double /*x*/, double y) { return 20 + y / 20; }

double builtSlope(double x, double y) {
    const bool tower = std::abs(x + 40) < 10 && std::abs(y) < 10,
               block = std::abs(x - 30) < 15 && std::abs(y) < 25;
    return slope(x, y) + (tower ? 30 : block ? 12 : 0);
}

TEST_F(TaskPlanTest, ASurfaceModelWithoutOutlinesEqualsOneStudyToTheLastBit) {
    request.files = {writeTerrain(folder.path("dsm.tif"), {-73.98, 40.75}, builtSlope).string(),
                     writeTerrain(folder.path("dtm.tif"), {-73.98, 40.75}, slope).string()};
    request.settings.engine = referenceEngine;
    const TaskPlan made = plan();
    EXPECT_FALSE(made.byExtent);
    const auto merged = runAndMerge(made);
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_EQ(onOneMachine().study.city.buildings.size(), 2U);
    expectEqualMaps(made, "plan/merged/shadow.tif", "whole.tif", 2);
}

// The ground is read without the buildings.
TEST_F(TaskPlanTest, AnExtentIsThatOfTheBuildingsWhereAGroundLiesBesideThem) {
    request.files.push_back(writeTerrain(folder.path("dtm.tif"), {-73.98, 40.75}, slope).string());
    request.reading.stand = Stand::terrain;
    request.reading.terrainShows = TerrainShows::ground;
    const Box2 all = bounds(plan().districts[0].region);
    request.reading.extent = LonLatBox{-73.98, 40.75, -73.979, 40.751};
    const TaskPlan part = plan();
    EXPECT_TRUE(part.byExtent);
    EXPECT_FALSE(part.districts[0].terrainHash.empty());
    EXPECT_LT(bounds(part.districts[0].region).high.x, all.high.x - 50);
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

// An inventory beside the town, with trees before some of its tiles only.
class TaskPlanTrees : public TaskPlanTest {
protected:
    TaskPlanTrees() { plant("Pinus nigra"); }
    void plant(const std::string& species) {
        const Frame frame({-73.98, 40.75});
        std::string trees = "tree_dbh,spc_latin,latitude,longitude\n";
        for (double x = 20; x < 70; x += 12) {
            const LonLat at = frame.lonLatFromLocal({x, 30});
            trees += fmt::format("20,{},{:.7f},{:.7f}\n", species, at.latDeg, at.lonDeg);
        }
        request.reading.treeFiles = {folder.file("trees.csv", trees).string()};
    }
};

TEST_F(TaskPlanTrees, CountAsOnOneMachineToTheLastBit) {
    const TaskPlan made = plan();
    const auto merged = runAndMerge(made);
    ASSERT_TRUE(merged) << merged.error().text();
    EXPECT_TRUE(merged->warnings.empty());
    const TiledStudy whole = onOneMachine();
    ASSERT_EQ(whole.withTrees.size(), 2U);
    for (const ShadedTiles& with : whole.withTrees) {
        const std::string name = "shadow" + suffixOf(with.column);
        expectEqualMaps(made, ("plan/merged/" + name + ".tif").c_str(), (name + ".tif").c_str(), 2);
        EXPECT_GT(with.statistics.meanGrossMin, whole.study.statistics.meanGrossMin);
        const std::string key = fmt::format("mean_gross_min{}", suffixOf(with.column));
        const auto json = nlohmann::json::parse(textOf("plan/merged/statistics.json"));
        EXPECT_NEAR(json.at(key).get<double>(), with.statistics.meanGrossMin, 1e-3);
    }
    // Tiles that no tree reaches show their bands without trees.
    const std::string mosaic = textOf("plan/merged/shadow_seasonal.vrt");
    EXPECT_THAT(mosaic, HasSubstr("<SourceBand>1</SourceBand>"));
    EXPECT_THAT(mosaic, HasSubstr("<SourceBand>5</SourceBand>"));
}

// A kilometre from any building, and before the sun when it is low only.
TEST_F(TaskPlanTrees, CountWhereNoBuildingStands) {
    const LonLat at = Frame({-73.98, 40.75}).lonLatFromLocal({1200, 90});
    request.reading.treeFiles = {
        folder
            .file("trees.csv", fmt::format("height,crown_diameter,latitude,longitude\n"
                                           "50,30,{:.7f},{:.7f}\n",
                                           at.latDeg, at.lonDeg))
            .string()};
    request.settings.period.window = SolarHours{};
    request.settings.period.stepMinutes = 5;
    const TaskPlan made = plan();
    ASSERT_TRUE(runAndMerge(made));
    const TiledStudy whole = onOneMachine();
    ASSERT_EQ(whole.withTrees.size(), 2U) << "the shadow reaches the town";
    expectEqualMaps(made, "plan/merged/shadow_evergreen.tif", "shadow_evergreen.tif", 2);
}

TEST_F(TaskPlanTrees, AnotherTreeIsAnotherContent) {
    const TaskPlan before = plan();
    plant("Betula pendula");
    const TaskPlan after = plan();
    ASSERT_EQ(before.tiles.size(), after.tiles.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < before.tiles.size(); ++i)
        changed += before.tiles[i].contentHash == after.tiles[i].contentHash ? 0 : 1;
    EXPECT_GT(changed, 0U);
}

}  // namespace
}  // namespace noonmark
