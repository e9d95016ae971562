#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <array>
#include <glm/geometric.hpp>

#include "core/geo/crs.h"
#include "core/io/elements/read_glazing.h"
#include "core/io/elements/write_elements.h"
#include "core/io/read_city.h"
#include "tests/core/io/citygml_fixtures.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {

namespace {

using tests::bonn;
using tests::cityGml;
using tests::gmlBoxSolid;
using tests::gmlBuilding;
using tests::gmlMultiSurface;
using tests::gmlPolygon;
using tests::TemporaryFolder;

// A wall with this opening in it.
std::string wallWith(const std::string& opening) {
    return "<bldg:boundedBy><bldg:WallSurface><bldg:opening>" + opening +
           "</bldg:opening></bldg:WallSurface></bldg:boundedBy>";
}

std::string openingOf(const std::string& kind, double x, const std::string& id = {}) {
    const auto at = [x](double dx, double z) { return bonn + glm::dvec3(x + dx, 0, z); };
    return fmt::format("<bldg:{0}{1}><bldg:lod3MultiSurface>{2}</bldg:lod3MultiSurface></bldg:{0}>", kind,
                       id.empty() ? "" : " gml:id=\"" + id + "\"",
                       gmlMultiSurface({gmlPolygon({at(0, 1), at(1, 1), at(1, 3), at(0, 3)})}));
}

TEST(CityGmlGlazing, WindowsAndDoorsOfWallsAreRead) {
    const TemporaryFolder folder;
    NoProgress quiet;
    const std::string house =
        gmlBuilding("house", gmlBoxSolid({0, 0, 0}, {10, 8, 6}) + wallWith(openingOf("Window", 1, "w7")) +
                                 wallWith(openingOf("Window", 4)) + wallWith(openingOf("Door", 7)));
    const auto file = folder.file("city.gml", cityGml(house));
    const auto city = readCity({file}, {}, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    EXPECT_NEAR(topM(*city->city.buildings.at(0)), 6, 1e-3) << "windows alone are no house";
    const auto read = readGlazing(file, {}, city->city, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    std::vector<std::string> ids;
    for (const GlazingShape& window : read->windows) ids.push_back(window.id);
    EXPECT_THAT(ids, testing::ElementsAre("w7", "house window 2", "house door 1"));
    const GlazingShape& first = read->windows.front();
    ASSERT_EQ(first.corners.size(), 4U);
    EXPECT_NEAR(first.corners[2].z - first.corners[0].z, 2, 1e-6);
    EXPECT_NEAR(first.corners[1].x - first.corners[0].x, 1, 0.01);
}

TEST(CityGmlGlazing, AFileWithoutWindowsSaysSo) {
    const TemporaryFolder folder;
    NoProgress quiet;
    const auto file = folder.file("city.gml", cityGml(gmlBuilding("a", gmlBoxSolid({0, 0, 0}, {9, 9, 9}))));
    const auto read = readGlazing(file, {}, City{}, quiet, {});
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().what, testing::HasSubstr("marked as a window or a door"));
}

using testing::HasSubstr;

// In the Dutch grid; heights above Amsterdam's datum.
constexpr double east = 90000, north = 437000;

// A wall 10 m wide that faces south, with a window of 2 x 1.5 m 3 m above its foot, and a door. Vertices are
// millimetres from (90000, 437000, 0).
std::string wallText(const std::string& semantics, const std::string& type = "MultiSurface",
                     const std::string& boundaries = "[[[0,1,2,3],[4,7,6,5]],[[4,5,6,7]],[[8,9,10,11]]]",
                     const std::string& values = "[0,1,2]") {
    return R"({"type":"CityJSON","version":"2.0","metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/7415"},
"transform":{"scale":[0.001,0.001,0.001],"translate":[90000,437000,0]},
"vertices":[[0,0,0],[10000,0,0],[10000,0,9000],[0,0,9000],[4000,0,3000],[6000,0,3000],[6000,0,4500],[4000,0,4500],
[1000,0,0],[2000,0,0],[2000,0,2000],[1000,0,2000]],
"CityObjects":{"house":{"type":"Building","geometry":[{"type":")" +
           type + R"(","lod":"3.2","boundaries":)" + boundaries + R"(,"semantics":{"values":)" + values +
           R"(,"surfaces":)" + semantics + "}}]}}}";
}
const std::string standard = R"([{"type":"WallSurface"},{"type":"Window","name":"kitchen"},{"type":"Door"}])";

class CityJsonGlazing : public testing::Test {
protected:
    Result<GlazingRead> read(const std::string& text, const GlazingFileSettings& settings = {}) {
        NoProgress quiet;
        return readGlazing(folder_.file("city.city.json", text), settings, city_, quiet, {});
    }
    City city_ = [] {
        City city;
        const std::array place{glm::dvec2(east, north)};
        city.frame = Frame(CrsToLonLat::of("EPSG:7415").value().lonLat(place)[0], 1);
        return city;
    }();
    tests::TemporaryFolder folder_;
};

TEST_F(CityJsonGlazing, SurfacesMarkedAsWindowOrDoorAreWindows) {
    const auto found = read(wallText(standard));
    ASSERT_TRUE(found) << found.error().text();
    ASSERT_EQ(found->windows.size(), 2U);
    const GlazingShape& window = found->windows[0];
    EXPECT_EQ(window.id, "kitchen");
    ASSERT_EQ(window.corners.size(), 4U);
    EXPECT_NEAR(window.corners[0].z, 2, 1e-6) << "3 m, and the frame begins at 1 m";
    EXPECT_NEAR(window.corners[2].z, 3.5, 1e-6);
    EXPECT_NEAR(glm::distance(window.corners[0], window.corners[1]), 2, 1e-3);
    EXPECT_NEAR(glm::length(glm::dvec2(window.corners[0])), 4, 1e-2);
    EXPECT_EQ(found->windows[1].id, "house door 1");
}

TEST_F(CityJsonGlazing, TheSameInASolidAndInASequence) {
    const auto solid =
        read(wallText(standard, "Solid", "[[[[0,1,2,3]],[[4,5,6,7]],[[8,9,10,11]]]]", "[[0,1,2]]"));
    ASSERT_TRUE(solid) << solid.error().text();
    EXPECT_EQ(solid->windows.size(), 2U);
    const auto lines = read(
        R"({"type":"CityJSON","version":"2.0","metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/7415"},"transform":{"scale":[0.001,0.001,0.001],"translate":[90000,437000,0]},"CityObjects":{},"vertices":[]}
{"type":"CityJSONFeature","id":"h","vertices":[[0,0,0],[2000,0,0],[2000,0,2000]],"CityObjects":{"h":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"3","boundaries":[[[0,1,2]]],"semantics":{"values":[0],"surfaces":[{"type":"Window"}]}}]}}}
)");
    ASSERT_TRUE(lines) << lines.error().text();
    ASSERT_EQ(lines->windows.size(), 1U);
    EXPECT_EQ(lines->windows[0].id, "h window 1");
}

TEST_F(CityJsonGlazing, HostileFilesAreErrorsOrWarnings) {
    EXPECT_THAT(read(wallText(R"([{"type":"WallSurface"},{"type":"RoofSurface"},{}])")).error().text(),
                HasSubstr("marked as a window"));
    // Indices beyond the vertices, negative ones, rings that are none.
    const auto broken =
        read(wallText(standard, "MultiSurface", "[[[0,1,2]],[[4,5,99]],[[8,9,10,11]]]", "[0,1,2]"));
    ASSERT_TRUE(broken);
    EXPECT_EQ(broken->windows.size(), 1U);
    EXPECT_EQ(broken->warnings.size(), 1U);
    for (const char* boundaries : {"null", "[1,2,3]", "[[[-1,-2,-3]],[[\"a\",1,2]],[[]]]", "[[[[[[0]]]]]]"})
        EXPECT_FALSE(read(wallText(standard, "MultiSurface", boundaries))) << boundaries;
    for (const char* values : {"null", "[7,8,9]", "[-1,-1,-1]", "[[0],[1],[2]]", "{}"})
        EXPECT_FALSE(read(wallText(standard, "MultiSurface", "[[[0,1,2]],[[4,5,6]],[[8,9,10]]]", values)))
            << values;
    GlazingFileSettings near;
    near.farAwayM = 1;
    city_.frame = Frame({0, 0});
    EXPECT_THAT(read(wallText(standard), near).error().text(), HasSubstr("too far"));
}

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
