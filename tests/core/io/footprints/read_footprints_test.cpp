#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/io/footprint_files.h"
#include "tests/shared/growing_progress.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(ReadFootprints, GeoJsonInDegrees) {
    const FilePiece piece =
        readGeoJson(feature(sizedRectangle(-20, -10, 40, 20), R"("id":"tower","name":"A","height":"30 m")"));
    ASSERT_EQ(piece.buildings.size(), 1U);
    ASSERT_TRUE(piece.frame);
    EXPECT_NEAR(piece.frame->origin().lonDeg, manhattan.lonDeg, 1e-7);
    EXPECT_NEAR(piece.frame->origin().latDeg, manhattan.latDeg, 1e-7);
    const Building& building = *piece.buildings[0];
    EXPECT_EQ(building.sourceId, "tower");
    EXPECT_EQ(building.name, "A");
    EXPECT_NEAR(area(building.parts[0].footprint), 800, 0.01);
    EXPECT_FLOAT_EQ(building.parts[0].topM, 30);
    EXPECT_EQ(piece.format, "GeoJSON");
    EXPECT_EQ(piece.features, 1U);
}

TEST_F(ReadFootprints, MultipolygonsAreOneBuilding) {
    const FilePiece piece = readGeoJson(
        R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"MultiPolygon","coordinates":[)"
        R"([[[0,0],[0.0002,0],[0.0002,0.0002],[0,0.0002],[0,0]]],[[[0.0003,0],[0.0005,0],[0.0005,0.0002],[0.0003,0.0002],[0.0003,0]]]]}})");
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_EQ(piece.buildings[0]->parts.size(), 2U);
}

TEST_F(ReadFootprints, PolygonsOfOneFeatureThatOverlapAreJoinedAndReported) {
    const FilePiece piece = readGeoJson(
        R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"MultiPolygon","coordinates":[)"
        R"([[[0,0],[0.0002,0],[0.0002,0.0002],[0,0.0002],[0,0]]],[[[0.0001,0],[0.0005,0],[0.0005,0.0002],[0.0001,0.0002],[0.0001,0]]]]}})");
    EXPECT_EQ(piece.buildings.at(0)->parts.size(), 1U);
    EXPECT_THAT(whats(piece.warnings), ElementsAre(HasSubstr("were joined")));
}

TEST_F(ReadFootprints, ElevationsInPolygonsAreNotTakenAndReported) {
    const FilePiece piece = readGeoJson(
        R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":)"
        R"([[[0,0,50],[0.0002,0,50],[0.0002,0.0002,50],[0,0.0002,50],[0,0,50]]]}})");
    EXPECT_FLOAT_EQ(piece.buildings.at(0)->parts[0].topM, 9);
    EXPECT_FLOAT_EQ(piece.buildings.at(0)->parts[0].bottomM, 0);
    EXPECT_THAT(whats(piece.warnings), ElementsAre(HasSubstr("elevations in its polygons")));
}

TEST_F(ReadFootprints, FeaturesOfOneBuildingIdAreOneBuilding) {
    const FilePiece piece = readGeoJson(
        feature(sizedRectangle(0, 0, 10, 10),
                R"("building_id":"b1","source_id":"low","height":9,"hangs":0)") +
        "," +
        feature(sizedRectangle(50, 0, 10, 10), R"("building_id":"b2","source_id":"x","height":9,"hangs":0)") +
        "," +
        feature(sizedRectangle(0, 0, 5, 5),
                R"("building_id":"b1","source_id":"high","height":30,"min_height":9,"hangs":1)"));
    ASSERT_EQ(piece.buildings.size(), 2U);
    EXPECT_EQ(piece.buildings[0]->sourceId, "b1");
    ASSERT_EQ(piece.buildings[0]->parts.size(), 2U);
    EXPECT_EQ(piece.buildings[0]->parts[1].sourceId, "high");
    EXPECT_TRUE(piece.buildings[0]->parts[1].isOverhanging);
}

TEST_F(ReadFootprints, APlaceholderIsNoBuildingId) {
    const FilePiece piece =
        readGeoJson(feature(sizedRectangle(0, 0, 10, 10), R"("building_id":0,"height":9)") + "," +
                    feature(sizedRectangle(50, 0, 10, 10), R"("building_id":0,"height":9)"));
    EXPECT_EQ(piece.buildings.size(), 2U);
}

TEST_F(ReadFootprints, ADrawingsLayersAreNotStoreysOfTheEarth) {
    const FilePiece piece = readGeoJson(
        feature(sizedRectangle(0, 0, 10, 10), R"("layer":"-1","location":"underground","height":9)"));
    EXPECT_EQ(piece.buildings.size(), 1U);
}

TEST_F(ReadFootprints, OneBadFeatureIsAWarning) {
    const FilePiece piece = readGeoJson(
        feature(sizedRectangle(0, 0, 10, 10), R"("height":9)") + "," +
        feature(sizedRectangle(20, 0, 10, 10), R"("height":9)") + "," +
        R"({"type":"Feature","properties":{"id":"lost"},"geometry":{"type":"Polygon","coordinates":[[[0,95],[1,95],[1,96],[0,95]]]}},)"
        R"({"type":"Feature","properties":{"id":"none"},"geometry":null},)"
        R"({"type":"Feature","properties":{"id":"line"},"geometry":{"type":"Polygon","coordinates":[[[-73.98,40.75],[-73.98,40.75],[-73.98,40.75]]]}})");
    EXPECT_EQ(piece.buildings.size(), 2U);
    std::vector<std::string> places;
    for (const Warning& warning : piece.warnings)
        if (warning.kind == WarningKind::dropped) places.push_back(warning.where);
    EXPECT_THAT(places, testing::UnorderedElementsAre("lost", "none", "line"));
}

TEST_F(ReadFootprints, ALayerMayBeChosen) {
    const auto file = folder.path("two.gpkg");
    writeRectangle(file, "GPKG", "EPSG:4326", {{"height", 12}});
    settings.layer = "houses";
    EXPECT_EQ(read(file).buildings.size(), 1U);
    settings.layer = "lots";
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("lots"), HasSubstr("houses")));
}

TEST_F(ReadFootprints, FilesThatCannotBeUsedAreOneClearError) {
    using testing::Not;
    const auto expectClear = [&](const std::filesystem::path& file) {
        const std::string text = errorOf(file);
        EXPECT_THAT(text, HasSubstr(file.filename().string()));
        EXPECT_THAT(text, Not(HasSubstr("\n")));
    };
    expectClear(folder.path("missing.geojson"));
    expectClear(folder.file("empty.geojson", ""));
    expectClear(folder.file("text.geojson", "These are not the buildings you are looking for.\n"));
    expectClear(folder.file("zero.shp", ""));
    expectClear(folder.file("nothing.geojson", R"({"type":"FeatureCollection","features":[]})"));
    expectClear(folder.file(
        "points.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1,2]}}]})"));
    expectClear(folder.file("none.osm", "<osm version=\"0.6\"></osm>"));
}

TEST_F(ReadFootprints, AMapWithoutBuildingsIsAnError) {
    OsmText osm;
    osm.way(sizedRectangle(0, 0, 10, 10), {{"building", "yes"}, {"location", "underground"}});
    EXPECT_THAT(errorOf(folder.file("cellar.osm", osm.xml())), HasSubstr("underground"));
}

TEST_F(ReadFootprints, CanBeStopped) {
    std::string features;
    for (int i = 0; i < 2000; ++i)
        features +=
            feature(sizedRectangle(float(i) * 12, 0, 10, 10), R"("height":9)") + (i < 1999 ? "," : "");
    std::stop_source stop;
    stop.request_stop();
    NoProgress quiet;
    const auto result = readFootprints(geoJson(features), settings, quiet, stop.get_token());
    ASSERT_FALSE(result);
    EXPECT_TRUE(isCancelled(result.error()));
}

TEST_F(ReadFootprints, ProgressOnlyGrowsAndEndsAtOne) {
    GrowingProgress progress;
    std::string features;
    for (int i = 0; i < 1000; ++i)
        features += feature(sizedRectangle(float(i) * 12, 0, 10, 10), R"("height":9)") + (i < 999 ? "," : "");
    ASSERT_TRUE(readFootprints(geoJson(features), settings, progress, {}));
    EXPECT_TRUE(progress.grew);
    EXPECT_DOUBLE_EQ(progress.last, 1);
}

}  // namespace
}  // namespace noonmark
