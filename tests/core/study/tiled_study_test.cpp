#include "core/study/tiles/tiled_study.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "core/city/map_context.h"
#include "core/city/trees/tree.h"
#include "core/engines/shade_trees.h"
#include "core/io/write_raster.h"
#include "core/lab/lab_engines.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/study_cost.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

City town() {
    City city = cityOf(randomBoxes(11, 10));
    city.frame = Frame({-73.98, 40.75});
    return city;
}

StudySettings question(const std::string& engine) {
    StudySettings settings;
    settings.region = {"cut", {{{{-30, -30}, {220, -10}, {210, 230}, {40, 200}}, {}}}};
    settings.period.zone = "America/New_York";
    settings.period.stepMinutes = 20;
    settings.period.days = 2;
    settings.engine = engine;
    return settings;
}

Study inOnePiece(const City& city, const StudySettings& settings) {
    NoProgress progress;
    return runStudy(city, settings, progress, {}).value();
}

void expectSame(const ShadowStatistics& a, const ShadowStatistics& b, double share) {
    EXPECT_EQ(a.receivers, b.receivers);
    EXPECT_EQ(a.receiverAreaM2, b.receiverAreaM2);
    EXPECT_NEAR(a.shadowAreaM2 / b.shadowAreaM2, 1, share);
    EXPECT_NEAR(a.meanGrossMin / b.meanGrossMin, 1, share);
    EXPECT_NEAR(a.meanContinuousMin / b.meanContinuousMin, 1, share);
}

bool same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

std::size_t differences(const std::vector<float>& a, const std::vector<float>& b) {
    std::size_t count = a.size() == b.size() ? 0 : a.size() + b.size();
    for (std::size_t i = 0; count <= a.size() && i < a.size(); ++i) count += same(a[i], b[i]) ? 0 : 1;
    return count;
}

class TiledStudyTest : public testing::Test {
protected:
    [[nodiscard]] Result<TiledStudy> run(const StudySettings& settings, Progress& progress,
                                         std::stop_token stop = {}) const {
        return runTiledStudy(city, {settings, 64}, file, progress, std::move(stop), coreAndLabEngines());
    }
    [[nodiscard]] Result<TiledStudy> run(const StudySettings& settings) const {
        NoProgress progress;
        return run(settings, progress);
    }
    [[nodiscard]] std::vector<std::vector<float>> bands(const Grid& grid) const {
        return readGeoTiff(file, grid).value();
    }

    City city = town();
    TemporaryFolder folder;
    std::filesystem::path file = folder.path("shadow.tif");
};

TEST_F(TiledStudyTest, IsTheSameAsInOnePiece) {
    const Study whole = inOnePiece(city, question("ray"));
    const auto tiled = run(question("ray"));
    ASSERT_TRUE(tiled) << tiled.error().text();
    EXPECT_EQ(tiled->plan.count(), 20U);
    EXPECT_GT(tiled->emptyTiles, 0U);
    EXPECT_EQ(tiled->tilesByEngine.at("ray"), 20 - tiled->emptyTiles);
    expectSame(tiled->study.statistics, whole.statistics, 1e-12);
    EXPECT_EQ(tiled->study.statistics.maxGrossMin, whole.statistics.maxGrossMin);
    EXPECT_EQ(tiled->study.statistics.maxContinuousMin, whole.statistics.maxContinuousMin);
    const auto cells = bands(whole.field.grid);
    EXPECT_EQ(differences(cells.at(0), whole.field.grossMin), 0U);
    EXPECT_EQ(differences(cells.at(1), whole.field.continuousMin), 0U);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"shadow.tif"});
}

TEST_F(TiledStudyTest, LeavesTheSameWaterOut) {
    MapContext map;
    map.areas = {{ContextKind::water, "River", {{{{-40, 60}, {230, 90}, {230, 160}, {-40, 100}}, {}}}}};
    city.context = std::make_shared<const MapContext>(map);
    const Study whole = inOnePiece(city, question("ray"));
    const auto tiled = run(question("ray"));
    ASSERT_TRUE(tiled) << tiled.error().text();
    EXPECT_GT(whole.statistics.waterM2, 1000);
    EXPECT_EQ(tiled->study.statistics.waterM2, whole.statistics.waterM2);
    EXPECT_EQ(tiled->study.statistics.receivers, whole.statistics.receivers);
    EXPECT_EQ(differences(bands(whole.field.grid).at(0), whole.field.grossMin), 0U);
}

// Two trees in the south-west: few of the twenty tiles are in their reach.
std::shared_ptr<const Trees> plantTwo() {
    const auto treeAt = [](double x, double y, bool evergreen) {
        return Tree{.place = {x, y},
                    .heightM = 9,
                    .crownBaseM = 2,
                    .crownDiameterM = 8,
                    .evergreen = evergreen,
                    .leafOnTransmissivity = 0.1F,
                    .leafOffTransmissivity = evergreen ? 0.1F : 0.7F};
    };
    return std::make_shared<const Trees>(Trees{{treeAt(5, 0, false), treeAt(30, 20, true)}, {106, 320}});
}

TEST_F(TiledStudyTest, TreesCountAsInOnePiece) {
    city.trees = plantTwo();
    const Study whole = inOnePiece(city, question("ray"));
    ASSERT_TRUE(whole.field.trees);
    const auto tiled = run(question("ray"));
    ASSERT_TRUE(tiled) << tiled.error().text();
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{"shadow.tif", "shadow_evergreen.tif", "shadow_seasonal.tif"}));
    EXPECT_EQ(differences(bands(whole.field.grid).at(0), whole.field.grossMin), 0U) << "without trees";
    ASSERT_EQ(tiled->withTrees.size(), 2);
    for (const ShadedTiles& with : tiled->withTrees) {
        const ShadowField& field = fieldOfColumn(whole.field, with.column);
        expectSame(with.statistics, computeStatistics(field), 1e-12);
        EXPECT_GT(with.statistics.meanGrossMin, whole.statistics.meanGrossMin);
        const auto cells =
            readGeoTiff(folder.path("shadow" + suffixOf(with.column) + ".tif"), whole.field.grid).value();
        EXPECT_EQ(differences(cells.at(0), field.grossMin), 0U);
        EXPECT_EQ(differences(cells.at(1), field.continuousMin), 0U);
    }
    const auto json = nlohmann::json::parse(tiledStudyJson(*tiled));
    const auto ofWhole = nlohmann::json::parse(studyJson(whole));
    for (const char* key : {"mean_gross_min_evergreen", "mean_gross_min_seasonal", "max_gross_min_seasonal"})
        EXPECT_EQ(json.at(key), ofWhole.at(key)) << key;
    for (const char* key : {"count", "used", "how", "shaded_from"})
        EXPECT_EQ(json.at("trees").at(key), ofWhole.at("trees").at(key)) << key;
    for (const auto& warning : json.at("warnings"))
        EXPECT_THAT(warning.at("what").get<std::string>(), testing::Not(testing::StartsWith("trees:")));
}

TEST_F(TiledStudyTest, MonthsCountTrees) {
    city = cityOf({{{0, 0, 0}, {90, 40, 60}}, {{130, 90, 0}, {190, 150, 45}}});
    city.frame = Frame({-73.98, 40.75});
    city.trees = plantTwo();
    StudySettings settings = question("projected");
    settings.byMonth = true;
    settings.period.start = {std::chrono::year(2026), std::chrono::January, std::chrono::day(1)};
    settings.period.days = 40;
    const Study whole = inOnePiece(city, settings);
    const auto tiled = run(settings);
    ASSERT_TRUE(tiled) << tiled.error().text();
    const auto ofTiles = listMonthsWithTrees(tiled->withTrees), ofWhole = listMonthsWithTrees(whole);
    ASSERT_EQ(ofTiles.size(), 2);
    ASSERT_EQ(ofWhole.size(), 2);
    for (std::size_t column = 0; column < 2; ++column) {
        ASSERT_EQ(ofTiles[column].months.size(), 2);
        for (std::size_t month = 0; month < 2; ++month)
            EXPECT_NEAR(ofTiles[column].months[month].meanMinutes / ofWhole[column].months[month].meanMinutes,
                        1, 1e-4);
        EXPECT_EQ(
            readGeoTiff(folder.path("by_month" + suffixOf(ofTiles[column].column) + ".tif"), whole.field.grid)
                .value()
                .size(),
            2);
    }
    EXPECT_LT(ofTiles[1].months[0].meanMinutes, ofTiles[0].months[0].meanMinutes) << "bare";
    // The sheet of the whole shows all three, hours of sun a day.
    const Bars bars = makeMonthBarsWithTrees(whole);
    ASSERT_EQ(bars.series.size(), 3);
    EXPECT_EQ(bars.series[2], "trees with their seasons");
    const std::vector<double>& january = bars.groups.at(0).values;
    ASSERT_EQ(january.size(), 3);
    EXPECT_GT(january[0], january[2]);
    EXPECT_GT(january[2], january[1]) << "bare in January";
}

TEST_F(TiledStudyTest, TreesOutOfReachOrUnwantedGiveNoColumns) {
    Trees trees = *plantTwo();
    for (Tree& tree : trees.trees) tree.place.x -= 5000;
    city.trees = std::make_shared<const Trees>(trees);
    const auto tiled = run(question("ray"));
    ASSERT_TRUE(tiled) << tiled.error().text();
    EXPECT_TRUE(tiled->withTrees.empty());
    EXPECT_EQ(folder.names(), std::vector<std::string>{"shadow.tif"});
    city.trees = plantTwo();
    StudySettings without = question("ray");
    without.trees = TreeColumns::without;
    EXPECT_TRUE(run(without)->withTrees.empty());
}

TEST_F(TiledStudyTest, ProjectedShadowsAndTheSweepTooButForCellsAtAnEdge) {
    for (std::string engine : {"projected", "horizon"}) {
        if (engine == "horizon") city = cityOf({{{0, 0, 0}, {90, 40, 60}}, {{130, 90, 0}, {190, 150, 45}}});
        const Study whole = inOnePiece(city, question(engine));
        const auto tiled = run(question(engine));
        ASSERT_TRUE(tiled) << tiled.error().text();
        expectSame(tiled->study.statistics, whole.statistics, 1e-4);
        const auto cells = bands(whole.field.grid);
        EXPECT_LE(differences(cells.at(0), whole.field.grossMin), whole.statistics.receivers / 500);
        ASSERT_TRUE(tiled->study.error);
        EXPECT_NEAR(double(tiled->study.error->receivers), 300, 100);
        EXPECT_LT(std::abs(tiled->study.error->areaPct), 0.5) << engine;
    }
}

TEST_F(TiledStudyTest, GrossShadowOnlyHasOneBandAndNoFiguresOfRuns) {
    StudySettings settings = question("horizon");
    settings.engineSettings["runs"] = 0;
    const auto tiled = run(settings);
    ASSERT_TRUE(tiled) << tiled.error().text();
    EXPECT_FALSE(hasRuns(tiled->study.statistics));
    EXPECT_GT(tiled->study.statistics.meanGrossMin, 0);
    EXPECT_EQ(bands(tiled->plan.whole).size(), 1U);
    const auto json = nlohmann::json::parse(tiledStudyJson(*tiled));
    EXPECT_TRUE(json["mean_continuous_min"].is_null());
    EXPECT_TRUE(json["max_continuous_min"].is_null());
    EXPECT_TRUE(json["error"]["continuous"].is_null());
    EXPECT_TRUE(json["error"]["gross"]["mean_pct"].is_number());
}

TEST_F(TiledStudyTest, MonthsAreThoseOfOnePiece) {
    StudySettings settings = question("projected");
    settings.errorSample.receivers = 0;
    settings.byMonth = true;
    settings.period.days = 40;
    settings.period.stepMinutes = 60;
    const Study whole = inOnePiece(city, settings);
    const auto tiled = run(settings);
    ASSERT_TRUE(tiled) << tiled.error().text();
    const auto cells = readGeoTiff(folder.path("by_month.tif"), whole.field.grid).value();
    const ShadowBreakdown& months = *whole.breakdown;
    ASSERT_EQ(cells.size(), 2U);
    ASSERT_EQ(months.minutes.size(), 2U);
    for (std::size_t month = 0; month < 2; ++month)
        EXPECT_LE(differences(cells[month], spreadOverGrid(months, month)), whole.statistics.receivers / 500);
    const auto expected = monthsOf(months);
    ASSERT_EQ(tiled->months.size(), 2U);
    for (std::size_t month = 0; month < 2; ++month) {
        EXPECT_EQ(tiled->months[month].month, expected[month].month);
        EXPECT_EQ(tiled->months[month].sunlitMinutes, expected[month].sunlitMinutes);
        EXPECT_NEAR(tiled->months[month].meanMinutes / expected[month].meanMinutes, 1, 1e-4);
        EXPECT_NEAR(tiled->months[month].shadowAreaM2 / expected[month].shadowAreaM2, 1, 1e-4);
    }
    EXPECT_EQ(nlohmann::json::parse(tiledStudyJson(*tiled))["by_month"].size(), 2U);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"by_month.tif", "shadow.tif"}));
}

TEST_F(TiledStudyTest, JsonSaysWhatTheWholeSaysAndWhatTheTilesDid) {
    const auto whole = nlohmann::json::parse(studyJson(inOnePiece(city, question("ray"))));
    auto inTiles = run(question("ray"));
    inTiles->study.provenance.inputs = {{"city.gpkg", 7, "abc"}};
    const auto tiled = nlohmann::json::parse(tiledStudyJson(*inTiles));
    for (const auto& [key, value] : whole.items())
        EXPECT_TRUE(key == "repeat_note" || tiled.contains(key)) << key;
    for (const char* key : {"receivers", "cells", "region", "rays", "buildings_used", "sunlit_min_per_day"})
        EXPECT_EQ(tiled[key], whole[key]) << key;
    EXPECT_EQ(tiled["tiles"]["count"], 20);
    EXPECT_EQ(tiled["engine_used"], "ray");
    EXPECT_THAT(tiled["repeat"].get<std::string>(), HasSubstr("noonmark-cli city-study city.gpkg"));
    EXPECT_EQ(whole["repeat_note"].get<std::string>().rfind("No command can repeat this result", 0), 0U);
}

/// Requests a stop when a number of tiles have begun, and records the progress.
struct StopAtTile final : Progress {
    explicit StopAtTile(int tile) : name(fmt::format("tile {} of", tile)) {}
    void report(double fraction, std::string_view stage) override {
        if (fraction < 0 || fraction > 1) wrong = true;
        if (stage.starts_with(name)) stop.request_stop();
    }
    std::string name;
    bool wrong = false;
    std::stop_source stop;
};

TEST_F(TiledStudyTest, GoesOnWhereItWasStoppedAndGivesTheSame) {
    const StudySettings settings = question("iam");
    const auto unbroken = run(settings);
    ASSERT_TRUE(unbroken) << unbroken.error().text();
    const auto cells = bands(unbroken->plan.whole);
    std::mt19937 random(5);
    for (int round = 0; round < 4; ++round) {
        std::filesystem::remove(file);
        StopAtTile watcher(2 + int(random() % 13));
        const auto stopped = run(settings, watcher, watcher.stop.get_token());
        ASSERT_FALSE(stopped) << watcher.name;
        EXPECT_TRUE(isCancelled(stopped.error()));
        EXPECT_FALSE(watcher.wrong);
        EXPECT_FALSE(std::filesystem::exists(file));
        const auto resumed = run(settings);
        ASSERT_TRUE(resumed) << resumed.error().text();
        EXPECT_GT(resumed->resumedTiles, 0U);
        EXPECT_LT(resumed->resumedTiles, 20U);
        expectSame(resumed->study.statistics, unbroken->study.statistics, 0);
        EXPECT_EQ(resumed->study.error->areaPct, unbroken->study.error->areaPct);
        EXPECT_EQ(resumed->study.error->receivers, unbroken->study.error->receivers);
        EXPECT_EQ(differences(bands(unbroken->plan.whole).at(0), cells.at(0)), 0U);
        EXPECT_EQ(differences(bands(unbroken->plan.whole).at(1), cells.at(1)), 0U);
    }
}

TEST_F(TiledStudyTest, GrossShadowOnlyGoesOnWhereItWasStopped) {
    StudySettings settings = question("horizon");
    settings.engineSettings["runs"] = 0;
    StopAtTile watcher(11);
    ASSERT_FALSE(run(settings, watcher, watcher.stop.get_token()));
    const auto resumed = run(settings);
    ASSERT_TRUE(resumed) << resumed.error().text();
    EXPECT_EQ(resumed->resumedTiles, 10U);
    EXPECT_FALSE(hasRuns(resumed->study.statistics));
}

TEST_F(TiledStudyTest, MonthsGoOnWhereTheyWereStopped) {
    StudySettings settings = question("projected");
    settings.errorSample.receivers = 0;
    settings.byMonth = true;
    settings.period.days = 40;
    settings.period.stepMinutes = 60;
    const auto unbroken = run(settings);
    ASSERT_TRUE(unbroken) << unbroken.error().text();
    const auto months = readGeoTiff(folder.path("by_month.tif"), unbroken->plan.whole).value();
    StopAtTile watcher(9);
    ASSERT_FALSE(run(settings, watcher, watcher.stop.get_token()));
    const auto resumed = run(settings);
    ASSERT_TRUE(resumed) << resumed.error().text();
    EXPECT_EQ(resumed->resumedTiles, 8U);
    for (std::size_t month = 0; month < 2; ++month) {
        EXPECT_EQ(resumed->months[month].meanMinutes, unbroken->months[month].meanMinutes);
        const auto again = readGeoTiff(folder.path("by_month.tif"), unbroken->plan.whole).value();
        EXPECT_EQ(differences(again[month], months[month]), 0U);
    }
}

TEST_F(TiledStudyTest, ABrokenTileIsReportedAndTheMapIsNotMade) {
    StopAtTile watcher(13);
    ASSERT_FALSE(run(question("ray"), watcher, watcher.stop.get_token()));
    for (const auto& entry : std::filesystem::directory_iterator(file.string() + ".tiles"))
        if (entry.path().extension() == ".tif") std::filesystem::resize_file(entry.path(), 50);
    const auto broken = run(question("ray"));
    ASSERT_FALSE(broken);
    EXPECT_THAT(broken.error().text(), HasSubstr("tile-"));
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(TiledStudyTest, FinishedTilesOfOtherSettingsAreNotMixedIn) {
    StopAtTile watcher(9);
    ASSERT_FALSE(run(question("ray"), watcher, watcher.stop.get_token()));
    StudySettings other = question("ray");
    other.period.hours = 5;
    const auto refused = run(other);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("another study"));
    EXPECT_TRUE(run(question("ray")));
}

TEST_F(TiledStudyTest, RefusesWhatRunStudyRefuses) {
    StudySettings settings = question("ray");
    settings.period.from = std::chrono::hours(0);
    settings.period.hours = 2;
    EXPECT_THAT(run(settings).error().text(), HasSubstr("below the horizon"));
    settings = question("magic");
    EXPECT_THAT(run(settings).error().text(), HasSubstr("magic"));
    settings = question("ray");
    settings.byMonth = true;
    EXPECT_THAT(run(settings).error().text(), HasSubstr("Choose one of"));
    settings = question("ray");
    settings.memoryLimit = 1000;
    EXPECT_THAT(run(settings).error().text(), HasSubstr("would need"));
    NoProgress progress;
    EXPECT_FALSE(runTiledStudy(city, {question("ray"), 20}, file, progress, {}));
    city = cityOf({{{-500, -500, 0}, {700, 700, 30}}});
    EXPECT_THAT(run(question("ray")).error().text(), HasSubstr("open ground"));
}

TEST_F(TiledStudyTest, MemoryIsThatOfATileNotOfTheRegion) {
    StudySettings settings = question("ray");
    settings.region = makeRegionFromLocalBox({{-30, -30}, {220, 230}});
    settings.memoryLimit = estimateMemory(city, settings) - 500'000;
    NoProgress progress;
    EXPECT_FALSE(runStudy(city, settings, progress, {}));
    EXPECT_TRUE(run(settings));
}

TEST(StudyHash, EverySettingAndEveryPointCounts) {
    const City city = town();
    const StudySettings settings = question("ray");
    const std::string hash = hashStudy(city, settings);
    EXPECT_EQ(hash.size(), 64U);
    EXPECT_EQ(hashStudy(town(), question("ray")), hash);
    std::vector<StudySettings> others(9, settings);
    others[0].period.hours = 5;
    others[1].period.refraction = false;
    others[2].receivers.cellM = 2;
    others[3].engine = "iam";
    others[4].engineSettings["levels"] = 2;
    others[5].region.polygons.front().outer.front().x += 1;
    others[6].errorSample.receivers = 299;
    others[7].temperatureC = 11;
    others[8].byMonth = true;
    for (std::size_t i = 0; i < others.size(); ++i) EXPECT_NE(hashStudy(city, others[i]), hash) << i;
    City higher = city;
    Building building = *city.buildings[40];
    building.parts.front().topM += 0.01F;
    higher.buildings[40] = std::make_shared<const Building>(building);
    EXPECT_NE(hashStudy(higher, settings), hash);
    MapContext map;
    map.areas = {{ContextKind::park, "Park", {city.buildings[40]->parts.front().footprint}}};
    City mapped = city;
    mapped.context = std::make_shared<const MapContext>(map);
    EXPECT_EQ(hashStudy(mapped, settings), hash) << "a park is ground";
    map.areas.front().kind = ContextKind::water;
    mapped.context = std::make_shared<const MapContext>(map);
    EXPECT_NE(hashStudy(mapped, settings), hash);
    building = *city.buildings[40];
    building.name = "Renamed";
    higher.buildings[40] = std::make_shared<const Building>(building);
    EXPECT_EQ(hashStudy(higher, settings), hash);
}

TEST(RemainingTime, InWords) {
    EXPECT_EQ(describeRemaining(3), "about 10 s left");
    EXPECT_EQ(describeRemaining(41), "about 50 s left");
    EXPECT_EQ(describeRemaining(1500), "about 25 min left");
    EXPECT_EQ(describeRemaining(9000), "about 2.5 h left");
}

}  // namespace
}  // namespace noonmark
