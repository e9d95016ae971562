#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/io/footprint_files.h"

// Coordinate systems, and where on the earth the footprints lie.
namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

TEST_F(ReadFootprints, ACityOnBothSidesOf180DegreesStaysTogether) {
    const LonLat taveuni{179.9999, -16.85};
    const FilePiece piece =
        readGeoJson(feature(sizedRectangle(-200, 0, 10, 10), R"("height":5)", taveuni) + "," +
                    feature(sizedRectangle(0, 0, 100, 10), R"("height":6)", taveuni) + "," +
                    feature(sizedRectangle(200, 0, 10, 10), R"("height":7)", taveuni));
    ASSERT_EQ(piece.buildings.size(), 3U);
    const double west = bounds(*piece.buildings[0]).low.x;
    EXPECT_NEAR(bounds(*piece.buildings[1]).low.x - west, 200, 0.01);
    EXPECT_NEAR(bounds(*piece.buildings[1]).high.x - west, 300, 0.01);
    EXPECT_NEAR(bounds(*piece.buildings[2]).low.x - west, 400, 0.01);
}

TEST_F(ReadFootprints, EverySystemIsReprojected) {
    for (const char* crs : {"EPSG:2263", "EPSG:3857", "EPSG:32618", "EPSG:4269"}) {
        const auto file = folder.path(std::string("a_") + (crs + 5) + ".gpkg");
        writeRectangle(file, "GPKG", crs, {{"height", 12}});
        const FilePiece piece = read(file);
        ASSERT_EQ(piece.buildings.size(), 1U) << crs;
        // The area must not be measured in Web Mercator, where it would be 1,394 m2, or in feet.
        EXPECT_NEAR(area(piece.buildings[0]->parts[0].footprint), 800, 0.1) << crs;
        EXPECT_NEAR(piece.frame->origin().latDeg, manhattan.latDeg, 2e-5) << crs;
    }
}

TEST_F(ReadFootprints, ShipsFarAwayDoNotStretchTheScene) {
    const LonLat sea{-77.0, 38.0};
    std::string features;
    for (int i = 0; i < 9; ++i)
        features +=
            feature(sizedRectangle(float(i) * 20, 0, 10, 10), fmt::format(R"("id":"h{}","height":9)", i)) +
            ",";
    const FilePiece piece =
        readGeoJson(features + feature(sizedRectangle(0, 0, 100, 20), R"("id":"ship","height":30)", sea));
    EXPECT_EQ(piece.buildings.size(), 9U);
    EXPECT_NEAR(piece.frame->origin().lonDeg, manhattan.lonDeg, 0.002);
    ASSERT_EQ(piece.warnings.size(), 1U);
    EXPECT_EQ(piece.warnings[0].kind, WarningKind::leftOut);
    EXPECT_EQ(piece.warnings[0].where, "ship");
}

TEST_F(ReadFootprints, TheOtherSideOfTheEarthIsFarAway) {
    const LonLat antipode{106.02, -40.75};
    std::string features = feature(sizedRectangle(0, 0, 10, 10), R"("height":9)") + "," +
                           feature(sizedRectangle(20, 0, 10, 10), R"("height":9)") + ",";
    const FilePiece piece =
        readGeoJson(features + feature(sizedRectangle(0, 0, 10, 10), R"("height":9)", antipode));
    EXPECT_EQ(piece.buildings.size(), 2U);
}

TEST_F(ReadFootprints, DataOnBothSidesOfTheDateLineStaysTogether) {
    const LonLat fiji{180, -17};
    std::string features;
    for (int i = -3; i <= 3; ++i)
        features += feature(sizedRectangle(float(i) * 200 + 50, 0, 10, 10), R"("height":9)", fiji) +
                    (i < 3 ? "," : "");
    const FilePiece piece = readGeoJson(features);
    EXPECT_EQ(piece.buildings.size(), 7U);
    EXPECT_NEAR(std::abs(piece.frame->origin().lonDeg), 180, 0.01);
}

TEST_F(ReadFootprints, JoinsTheFrameOfAProject) {
    settings.frame = Frame({-73.97, 40.75}, 10);
    const FilePiece piece =
        readGeoJson(feature(sizedRectangle(0, 0, 10, 10), R"("height":9,"ground_elevation":25)"));
    EXPECT_FALSE(piece.frame);
    EXPECT_LT(bounds(*piece.buildings.at(0)).high.x, -800);
    EXPECT_FLOAT_EQ(piece.buildings[0]->parts[0].bottomM, 15);
    ASSERT_EQ(piece.groundM.size(), 1U);
    EXPECT_FLOAT_EQ(piece.groundM[0].value(), 15);
}

TEST_F(ReadFootprints, WithoutASystemTheUserMustStateIt) {
    const auto file = folder.path("a.shp");
    writeRectangle(file, "ESRI Shapefile", "EPSG:2263", {{"height_m", 12}});
    std::filesystem::remove(folder.path("a.prj"));
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("a.shp"), HasSubstr("--crs")));
    settings.crs = "EPSG:2263";
    const FilePiece piece = read(file);
    EXPECT_NEAR(area(piece.buildings.at(0)->parts[0].footprint), 800, 0.1);
    settings.crs = "EPSG:999999";
    EXPECT_THAT(errorOf(file), HasSubstr("EPSG:999999"));
}

// The reader's library would say an option of its own.
TEST_F(ReadFootprints, AShapefileWithoutItsIndexSaysWhichFileIsMissing) {
    const auto file = folder.path("a.shp");
    writeRectangle(file, "ESRI Shapefile", "EPSG:2263", {{"height_m", 12}});
    EXPECT_EQ(read(file).buildings.size(), 1U);
    std::filesystem::remove(folder.path("a.shx"));
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("the same name that ends in .shx"),
                                              HasSubstr("save it as GeoPackage")));
}

std::string topology(const std::string& corners) {
    return R"({"type":"Topology","objects":{"town":{"type":"GeometryCollection","geometries":[)"
           R"({"type":"Polygon","arcs":[[0]],"properties":{"height":12}}]}},"arcs":[[)" +
           corners + "]]}";
}

// The format has no place for a reference system.
TEST_F(ReadFootprints, ATopologyInDegreesIsTakenForThem) {
    const FilePiece piece = read(folder.file(
        "a.topojson",
        topology("[-73.98,40.75],[-73.9798,40.75],[-73.9798,40.7501],[-73.98,40.7501],[-73.98,40.75]")));
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_EQ(piece.buildings[0]->parts[0].topM, 12);
    EXPECT_THAT(piece.crs, HasSubstr("WGS 84, guessed from the numbers"));
    EXPECT_THAT(whats(piece.warnings), testing::Contains(HasSubstr("its numbers are taken for degrees")));
    EXPECT_THAT(errorOf(folder.file("b.topojson", topology("[980000,210000],[980100,210000],[980100,210100],"
                                                           "[980000,210000]"))),
                HasSubstr("--crs"));
}

TEST_F(ReadFootprints, CoordinatesThatCannotBeDegreesAreAnError) {
    const auto file =
        geoJson(R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":)"
                R"([[[980000,210000],[980100,210000],[980100,210100],[980000,210000]]]}})");
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("WGS 84"), HasSubstr("--crs")));
    settings.crs = "EPSG:2263";
    EXPECT_EQ(read(file).buildings.size(), 1U);
}

TEST_F(ReadFootprints, DegreesThatCallThemselvesFeetAreAnError) {
    const auto file = geoJson(feature(sizedRectangle(0, 0, 10, 10), R"("height":9)"));
    for (const char* crs : {"EPSG:2263", "EPSG:3857", "EPSG:32618"}) {
        settings.crs = crs;
        EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("look like degrees"), HasSubstr("--crs"))) << crs;
    }
}

}  // namespace
}  // namespace noonmark
