#include "core/io/elements/read_glazing.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/elements/write_elements.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

City emptyCity() {
    City city;
    city.frame = Frame({4.45, 51.91});
    return city;
}

Result<GlazingRead> readGlazingFrom(const std::filesystem::path& file,
                                    const GlazingFileSettings& settings = {}) {
    NoProgress quiet;
    return readGlazing(file, settings, emptyCity(), quiet, {});
}

class ReadGlazing : public testing::Test {
protected:
    // Features of these geometries, with properties.
    std::filesystem::path fileOf(const std::vector<std::pair<std::string, std::string>>& features) {
        std::string text;
        for (const auto& [properties, geometry] : features)
            text += fmt::format("{}{{\"type\":\"Feature\",\"properties\":{{{}}},\"geometry\":{}}}",
                                text.empty() ? "" : ",\n", properties, geometry);
        return folder_.file("windows.geojson", R"({"type":"FeatureCollection","features":[)" + text + "]}");
    }
    static std::string point(const std::string& coordinates) {
        return R"({"type":"Point","coordinates":[)" + coordinates + "]}";
    }

    tests::TemporaryFolder folder_;
};

TEST_F(ReadGlazing, PointsAndPanesWithTheirFields) {
    const auto read = readGlazingFrom(fileOf(
        {{R"("ID":"W1","facing":270,"storey":"4")", point("4.45,51.91,12.5")},
         {R"("ID":"W2")",
          R"({"type":"Polygon","coordinates":[[[4.45,51.91,1],[4.4501,51.91,1],[4.4501,51.91,2],[4.45,51.91,1]]]})"},
         {R"("ID":"W3")", R"({"type":"MultiPoint","coordinates":[[4.45,51.91,1],[4.45,51.91,2]]})"}}));
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->windows.size(), 4U);
    EXPECT_EQ(read->windows[0].id, "W1");
    EXPECT_EQ(read->windows[0].azimuthDeg, 270);
    EXPECT_EQ(read->windows[0].floor, 4);
    EXPECT_NEAR(read->windows[0].corners[0].z, 12.5, 1e-9);
    EXPECT_NEAR(read->windows[0].corners[0].x, 0, 1e-3);
    EXPECT_EQ(read->windows[1].corners.size(), 3U);
    EXPECT_EQ(read->windows[2].id, "W3/1");
    EXPECT_EQ(read->windows[3].id, "W3/2");
    EXPECT_TRUE(read->warnings.empty());
}

TEST_F(ReadGlazing, ElevationsAreLoweredToTheFrame) {
    City city;
    city.frame = Frame({4.45, 51.91}, 3);
    NoProgress quiet;
    const auto file = fileOf({{R"("id":"a")", point("4.45,51.91,5")}});
    EXPECT_NEAR(readGlazing(file, {}, city, quiet, {}).value().windows[0].corners[0].z, 2, 1e-9);
    EXPECT_NEAR(readGlazing(file, {.aboveGround = true}, city, quiet, {}).value().windows[0].corners[0].z, 5,
                1e-9);
}

TEST_F(ReadGlazing, WhatIsNoWindowIsCountedAndListed) {
    const auto read = readGlazingFrom(
        fileOf({{R"("id":"good")", point("4.45,51.91,3")},
                {R"("id":"flat")", point("4.45,51.91")},
                {R"("id":"endless")", point("1e999,51.91,3")},
                {R"("id":"high")", point("4.45,51.91,1e300")},
                {R"("id":"far")", point("14.45,51.91,3")},
                {R"("id":"none")", "null"},
                {R"("id":"line")", R"({"type":"LineString","coordinates":[[4.45,51.91,1],[4.46,51.91,1]]})"},
                {R"("id":"odd","azimuth":"south")", point("4.45,51.91,3")}}));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->features, 8U);
    ASSERT_EQ(read->windows.size(), 2U);
    EXPECT_FALSE(read->windows[1].azimuthDeg);
    std::vector<std::string> listed;
    for (const Warning& warning : read->warnings) listed.push_back(warning.where);
    EXPECT_THAT(listed,
                testing::UnorderedElementsAre("flat", "endless", "high", "far", "none", "line", "odd"));
}

TEST_F(ReadGlazing, AFileWithoutAnyUsableWindowSaysWhy) {
    const auto flat = readGlazingFrom(fileOf({{R"("id":"a")", point("4.45,51.91")}}));
    ASSERT_FALSE(flat);
    EXPECT_THAT(flat.error().text(), HasSubstr("no height"));
    const auto lines = readGlazingFrom(
        fileOf({{R"("id":"a")", R"({"type":"LineString","coordinates":[[4.45,51.91,1],[4.46,51.91,1]]})"}}));
    ASSERT_FALSE(lines);
    EXPECT_THAT(lines.error().text(), HasSubstr("neither a point nor a polygon"));
    EXPECT_THAT(lines.error().advice, HasSubstr("PointZ"));
    EXPECT_FALSE(readGlazingFrom(fileOf({})));
    EXPECT_FALSE(readGlazingFrom(folder_.file("noise.gpkg", "this is no GeoPackage")));
    EXPECT_FALSE(readGlazingFrom(folder_.path("missing.gpkg")));
}

TEST_F(ReadGlazing, AMissingIdFieldNamesTheOthers) {
    const auto file = fileOf({{R"("flat":"3b")", point("4.45,51.91,3")}});
    const auto read = readGlazingFrom(file, {.idField = "window_no"});
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().text(), HasSubstr("window_no"));
    EXPECT_THAT(read.error().advice, HasSubstr("flat"));
    EXPECT_EQ(readGlazingFrom(file, {.idField = "FLAT"}).value().windows[0].id, "3b");
}

TEST_F(ReadGlazing, ThousandsOfThem) {
    std::vector<std::pair<std::string, std::string>> features;
    for (int i = 0; i < 5000; ++i)
        features.emplace_back(fmt::format(R"("id":{})", i), point(fmt::format("4.45,51.91,{}", i % 50)));
    EXPECT_EQ(readGlazingFrom(fileOf(features)).value().windows.size(), 5000U);
}

// What writeElementsGeoPackage() writes is a file of windows again: points with z and an id.
TEST_F(ReadGlazing, ReadTheGeoPackageOfElements) {
    ElementTable table{.columns = {{"id", std::string()}, {"floor", std::int64_t(0)}, {"azimuth_deg", 0.0}}};
    table.rows = {{std::string("a"), std::int64_t(2), 90.5},
                  {std::string("b"), std::monostate(), std::nan("")}};
    table.places = {{4.45, 51.91, 7.25}, {4.451, 51.91, -1}};
    const auto file = folder_.path("elements.gpkg");
    ASSERT_TRUE(writeElementsGeoPackage(file, table));
    const auto read = readGlazingFrom(file);
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->windows.size(), 2U);
    EXPECT_EQ(read->windows[0].id, "a");
    EXPECT_EQ(read->windows[0].azimuthDeg, 90.5);
    EXPECT_EQ(read->windows[0].floor, 2);
    EXPECT_EQ(read->windows[0].corners[0].z, 7.25);
    EXPECT_FALSE(read->windows[1].azimuthDeg);
    EXPECT_FALSE(read->windows[1].floor);
    EXPECT_FALSE(writeElementsGeoPackage(folder_.path("no folder/elements.gpkg"), table));
}

}  // namespace
}  // namespace noonmark
