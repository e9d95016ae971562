#include "core/io/read_region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/city/footprints/footprint.h"
#include "core/study/text/region_text.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

const Frame frame({-73.98, 40.75});

double computeArea(const Region& region) {
    double sum = 0;
    for (const Footprint& polygon : region.polygons) sum += area(polygon);
    return sum;
}

std::string regionError(const Result<Region>& region) { return region ? "no error" : region.error().text(); }

std::string collection(const std::string& geometries, const std::string& crs = "") {
    return R"({"type":"FeatureCollection",)" + crs + R"("features":[)" + geometries + "]}";
}
std::string feature(const std::string& type, const std::string& coordinates) {
    return R"({"type":"Feature","properties":{},"geometry":{"type":")" + type + R"(","coordinates":)" +
           coordinates + "}}";
}
constexpr const char* block =
    "[[[-73.985,40.748],[-73.975,40.748],[-73.975,40.752],[-73.985,40.752],[-73.985,40.748]]]";

TEST(ReadRegion, BoxInDegrees) {
    const auto region = readRegion("-73.985,40.748,-73.975,40.752", frame);
    ASSERT_TRUE(region) << regionError(region);
    EXPECT_NEAR(computeArea(*region), 844.6 * 444.2, 0.002 * 844.6 * 444.2);
    EXPECT_TRUE(readRegion(" -73.985, 40.748, -73.975, 40.752", frame));
}

TEST(ReadRegion, AcrossTheAntimeridian) {
    const Frame taveuni({180, -16.85});
    const auto box = readRegion("179.99,-16.86,-179.99,-16.84", taveuni);
    ASSERT_TRUE(box) << regionError(box);
    EXPECT_NEAR(computeArea(*box), 2130.4 * 2213.1, 0.002 * 2130.4 * 2213.1);
    // In the form that people write and in that of regionGeoJson.
    for (const char* east : {"-179.99", "180.01"}) {
        const std::string ring = std::string("((179.99 -16.86, ") + east + " -16.86, " + east +
                                 " -16.84, 179.99 -16.84, 179.99 -16.86))";
        const auto polygon = readRegion("POLYGON " + ring, taveuni);
        ASSERT_TRUE(polygon) << regionError(polygon);
        EXPECT_NEAR(computeArea(*polygon), computeArea(*box), 1);
    }
    tests::TemporaryFolder folder;
    const Region drawn{"drawn", {Footprint{{{-300, 0}, {400, 20}, {0, 500}}, {}}}};
    const auto again =
        readRegion(folder.file("region.geojson", regionGeoJson(drawn, taveuni)).string(), taveuni);
    ASSERT_TRUE(again) << regionError(again);
    EXPECT_NEAR(computeArea(*again), computeArea(drawn), 0.5);  // its sides are straight in degrees
}

TEST(ReadRegion, BoxThatIsNotOne) {
    EXPECT_THAT(regionError(readRegion("-73.985,40.748,-73.975", frame)), HasSubstr("four numbers"));
    EXPECT_THAT(regionError(readRegion("-73.985,40.748,-73.975,40.752,7", frame)), HasSubstr("four numbers"));
    EXPECT_THAT(regionError(readRegion("-73.985,40.748,-73.975,north", frame)), HasSubstr("four numbers"));
    EXPECT_THAT(regionError(readRegion("", frame)), HasSubstr("four numbers"));
    EXPECT_THAT(regionError(readRegion("-73.975,40.748,-73.985,40.752", frame)), HasSubstr("empty"));
    EXPECT_FALSE(readRegion("nan,40.748,-73.985,40.752", frame));
}

TEST(ReadRegion, BoxOfAnotherCity) {
    EXPECT_THAT(regionError(readRegion("13.3,52.5,13.4,52.6", frame)), HasSubstr("km from the city"));
    EXPECT_THAT(regionError(readRegion("40.748,-73.985,40.752,-73.975", frame)),
                HasSubstr("west,south,east,north"));
}

TEST(ReadRegion, WellKnownTextIsTheSamePlaceAsTheBox) {
    const auto box = readRegion("-73.985,40.748,-73.975,40.752", frame);
    const auto polygon = readRegion(
        "Polygon ((-73.985 40.748, -73.975 40.748, -73.975 40.752, -73.985 40.752, -73.985 40.748))", frame);
    ASSERT_TRUE(polygon) << regionError(polygon);
    EXPECT_NEAR(computeArea(*polygon), computeArea(*box), 1);
    const auto two = readRegion(
        " MULTIPOLYGON (((-73.985 40.748, -73.98 40.748, -73.98 40.752, -73.985 40.748)),"
        " ((-73.98 40.748, -73.975 40.748, -73.975 40.752, -73.98 40.748)))",
        frame);
    ASSERT_TRUE(two) << regionError(two);
    EXPECT_EQ(two->polygons.size(), 2U);
}

TEST(ReadRegion, WellKnownTextThatIsNone) {
    EXPECT_THAT(regionError(readRegion("POLYGON ((1 2", frame)), HasSubstr("well-known text"));
    EXPECT_THAT(regionError(readRegion("POLYGON EMPTY", frame)), HasSubstr("no area"));
    EXPECT_THAT(regionError(readRegion("POLYGON ((13.3 52.5, 13.4 52.5, 13.4 52.6, 13.3 52.5))", frame)),
                HasSubstr("km from the city"));
    EXPECT_FALSE(readRegion("POLYGON ((nan 40, -73 40, -73 41, nan 40))", frame));
}

TEST(ReadRegion, PolygonFileIsTheSamePlaceAsTheBox) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file("block.geojson", collection(feature("Polygon", block)));
    const auto region = readRegion(file.string(), frame);
    ASSERT_TRUE(region) << regionError(region);
    EXPECT_EQ(region->name, "block");
    const auto box = readRegion("-73.985,40.748,-73.975,40.752", frame);
    EXPECT_NEAR(computeArea(*region), computeArea(*box), 1);
    EXPECT_NEAR(bounds(*region).low.x, bounds(*box).low.x, 0.01);
    EXPECT_NEAR(bounds(*region).high.y, bounds(*box).high.y, 0.01);
}

TEST(ReadRegion, AllPolygonsCountAndNothingElse) {
    const tests::TemporaryFolder folder;
    const std::string two =
        "[[[[-73.980,40.75],[-73.979,40.75],[-73.979,40.751],[-73.980,40.75]]],"
        "[[[-73.970,40.75],[-73.969,40.75],[-73.969,40.751],[-73.970,40.75]]]]";
    const auto file = folder.file(
        "three.geojson", collection(feature("Polygon", block) + "," + feature("MultiPolygon", two) + "," +
                                    feature("Point", "[-73.98,40.75]")));
    const auto region = readRegion(file.string(), frame);
    ASSERT_TRUE(region) << regionError(region);
    EXPECT_EQ(region->polygons.size(), 3U);
}

TEST(ReadRegion, ProjectedFeetAreReprojected) {
    const tests::TemporaryFolder folder;
    // New York State Plane, feet: 1000 ft x 500 ft near Bryant Park.
    const auto file = folder.file(
        "feet.geojson",
        collection(
            feature("Polygon",
                    "[[[988000,213000],[989000,213000],[989000,213500],[988000,213500],[988000,213000]]]"),
            R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2263"}},)"));
    const auto region = readRegion(file.string(), frame);
    ASSERT_TRUE(region) << regionError(region);
    const double squareFootM2 = 0.3048006 * 0.3048006;
    EXPECT_NEAR(computeArea(*region), 1000 * 500 * squareFootM2, 0.001 * 1000 * 500 * squareFootM2);
}

TEST(ReadRegion, BowTieIsRepaired) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file(
        "bow.geojson",
        collection(feature(
            "Polygon", "[[[-73.98,40.75],[-73.97,40.76],[-73.97,40.75],[-73.98,40.76],[-73.98,40.75]]]")));
    const auto region = readRegion(file.string(), frame);
    ASSERT_TRUE(region) << regionError(region);
    EXPECT_EQ(region->polygons.size(), 2U);
}

TEST(ReadRegion, FilesThatAreNoRegion) {
    const tests::TemporaryFolder folder;
    EXPECT_THAT(regionError(readRegion(folder.file("words.txt", "hello").string(), frame)),
                HasSubstr("words.txt"));
    EXPECT_THAT(regionError(readRegion(folder.file("empty.geojson", collection("")).string(), frame)),
                HasSubstr("no polygon"));
    EXPECT_THAT(
        regionError(readRegion(
            folder.file("points.geojson", collection(feature("Point", "[-73.98,40.75]"))).string(), frame)),
        HasSubstr("no polygon"));
    EXPECT_THAT(
        regionError(readRegion(
            folder.file("metres.geojson", collection(feature("Polygon", "[[[0,0],[500,0],[500,500],[0,0]]]")))
                .string(),
            frame)),
        HasSubstr("CRS"));
    EXPECT_THAT(regionError(readRegion(folder.path("missing.geojson").string(), frame)),
                HasSubstr("no such file"));
}

TEST(ReadRegion, APointFarOffIsReportedAtOnce) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file(
        "far.geojson",
        collection(
            feature("Polygon", "[[[-73.98,40.75],[1e9,40.75],[1e9,40.76],[-73.98,40.76],[-73.98,40.75]]]")));
    EXPECT_THAT(regionError(readRegion(file.string(), frame)), HasSubstr("is outside the range of"));
}

TEST(ReadRegion, FileWithoutCrs) {
    const tests::TemporaryFolder folder;
    const auto file = folder.file("plain.csv", "id,WKT\n1,\"POLYGON((0 0,10 0,10 10,0 0))\"\n");
    EXPECT_THAT(regionError(readRegion(file.string(), frame)), HasSubstr("coordinate reference system"));
}

}  // namespace
}  // namespace noonmark
