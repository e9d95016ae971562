#include "core/study/terrain_coverage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/study/study.h"
#include "core/study/text/terrain_text.h"
#include "core/study/tiles/tiled_study.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

// A terrain from -50 to 50 on each axis, and houses along y = 0 every 40 m from x = -40 to 760.
City halfCovered() {
    City city{.frame = Frame({11.96, 57.7})};
    city.terrain = std::make_shared<const Terrain>(
        Terrain{PostGrid(-50, -50, 2, 50, 50), std::vector<float>(2500, 1), {.file = "ground.tif"}});
    for (int i = 0; i < 21; ++i)
        city.buildings.push_back(
            buildingOf({rectangle(float(i) * 40 - 45, -5, float(i) * 40 - 35, 5), {}}, 1, 11));
    return city;
}

StudySettings over(float east) {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-50, -50}, {east, 50}});
    settings.region.name = "park";
    settings.receivers.cellM = 1;
    settings.engine = "ray";
    settings.errorSample.receivers = 0;
    settings.period.zone = "UTC";
    settings.period.from = std::chrono::hours(11);
    settings.period.hours = 1;
    settings.period.stepMinutes = 20;
    return settings;
}

Result<Study> studied(float east) {
    NoProgress progress;
    return runStudy(halfCovered(), over(east), progress, {});
}

TEST(TerrainCoverage, ARegionOnTheTerrainHasNothingToState) {
    const Study study = studied(40).value();
    EXPECT_EQ(study.terrainCoverage.receivers.all, study.receivers.cells.size());
    EXPECT_EQ(study.terrainCoverage.receivers.off, 0U);
    EXPECT_TRUE(makeWarnings(study.terrainCoverage).empty() || study.terrainCoverage.casters.off > 0);
    EXPECT_EQ(nlohmann::json::parse(studyJson(study))["beyond_terrain"]["receivers"]["off"], 0);
}

// The region is 180 m wide; 80 m of it are beyond the terrain.
TEST(TerrainCoverage, WhatLiesBeyondIsCountedAndStated) {
    const Study study = studied(130).value();
    const auto& share = study.terrainCoverage.receivers;
    std::size_t off = 0;
    for (const std::uint32_t cell : study.receivers.cells)
        off += study.receivers.position(cell).x > 50 ? 1 : 0;
    EXPECT_EQ(share.all, study.receivers.cells.size());
    EXPECT_EQ(share.off, off);
    EXPECT_NEAR(double(share.off) / double(share.all), 80.0 / 180, 0.02);
    EXPECT_NEAR(share.farthestM, 129.5 - 49, 0.1);
    const std::string text = studyJson(study);
    EXPECT_THAT(text, HasSubstr("receivers beyond the terrain are at its nearest elevation"));
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json["beyond_terrain"]["receivers"]["off"], share.off);
    EXPECT_EQ(json["terrain"]["file"], "ground.tif");
    EXPECT_THAT(formatText(study.terrainCoverage), HasSubstr("Beyond the terrain"));
}

TEST(TerrainCoverage, ARegionMostlyBeyondItIsRefused) {
    const auto study = studied(160);
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().text(), HasSubstr("receivers lie beyond the terrain"));
    EXPECT_THAT(study.error().text(), HasSubstr("park"));
    const TemporaryFolder folder;
    NoProgress progress;
    const auto tiled = runTiledStudy(halfCovered(), {.study = over(160), .tileCells = 64},
                                     folder.path("map.tif"), progress, {});
    ASSERT_FALSE(tiled);
    EXPECT_THAT(tiled.error().text(), HasSubstr("receivers lie beyond the terrain"));
}

TEST(TerrainCoverage, TilesCountTheRegionsCells) {
    const TemporaryFolder folder;
    NoProgress progress;
    const TiledStudy tiled = runTiledStudy(halfCovered(), {.study = over(130), .tileCells = 64},
                                           folder.path("map.tif"), progress, {})
                                 .value();
    EXPECT_EQ(tiled.study.terrainCoverage.receivers.all, 180U * 100U);
    EXPECT_EQ(tiled.study.terrainCoverage.receivers.off, 80U * 100U);
    EXPECT_FALSE(tiled.study.warnings.empty());
}

// Low suns from the east: most houses whose shadow can reach the region are farther away than the terrain is
// wide.
TEST(TerrainCoverage, HousesInReachFarFromItAreRefused) {
    StudySettings settings = over(40);
    settings.period.from = std::chrono::minutes(5 * 60 + 10);
    settings.period.stepMinutes = 2;
    NoProgress progress;
    const auto study = runStudy(halfCovered(), settings, progress, {});
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().text(), HasSubstr("buildings whose shadow can reach the region lie far"));
}

TEST(TerrainSource, ComesBackFromItsText) {
    TerrainSource source{.method = TerrainMethod::averaged,
                         .file = "dem \"2\".tif",
                         .sourceColumns = 12000,
                         .sourceRows = 9000,
                         .sourceCellM = 0.5,
                         .misplacedM = 0.0031,
                         .heightRmsM = 0.25,
                         .heightMaxM = 3.5,
                         .filled = 17,
                         .impossible = 3,
                         .cut = true};
    Terrain terrain{PostGrid(-50, -50, 2, 50, 50), {}, source};
    terrain.grid.bend[3] = {0.1, 1e-17 / 3};
    Terrain back{PostGrid(0, 0, 1, 50, 50), {}};
    back.grid.cellM = 2;
    EXPECT_TRUE(takeSource(sourceText(terrain), back));
    EXPECT_EQ(back, terrain);
    for (const char* text : {"", "no JSON", "[]", "{\"method\": 7}", "{}"}) {
        EXPECT_TRUE(takeSource(text, back)) << text;
        EXPECT_EQ(back.source, TerrainSource{}) << text;
        EXPECT_EQ(back.grid, terrain.grid);
    }
    EXPECT_FALSE(takeSource(R"({"posts": [1, 2]})", back));
    std::string turned = "{\"posts\": [0,0, 0,1, 1,0";
    for (std::size_t i = 0; i < PostGrid::bendTerms; ++i) turned += ", 0,0";
    EXPECT_FALSE(takeSource(turned + "]}", back));
}

}  // namespace
}  // namespace noonmark::tests
