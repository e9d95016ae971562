#include "core/io/files/plain_file.h"

#include <gtest/gtest.h>

#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using namespace std::string_view_literals;

FileKind getKind(std::string_view content, const std::string& name = "file") {
    const tests::TemporaryFolder folder;
    const auto kind = detectFileKind(folder.file(name, content));
    EXPECT_TRUE(kind) << (kind ? "" : kind.error().text()) << " for " << content;
    return kind.value_or(FileKind{-1});
}

TEST(FileKind, JsonIsToldByItsKeysInAnyOrder) {
    EXPECT_EQ(getKind(R"({"type":"CityJSON","version":"2.0"})"), FileKind::cityJson);
    EXPECT_EQ(
        getKind(R"({"version":"1.1","vertices":[[1,2,3]],"metadata":{"type":"Feature"},"type":"CityJSON"})"),
        FileKind::cityJson);
    EXPECT_EQ(getKind("{\"type\":\"CityJSON\"}\n{\"type\":\"CityJSONFeature\"}\n"), FileKind::cityJson);
    EXPECT_EQ(getKind("\xEF\xBB\xBF \n{\"type\":\"FeatureCollection\",\"features\":[]}"),
              FileKind::footprints);
    EXPECT_EQ(getKind(R"({"name":"x","crs":{"type":"name"},"features":[)"), FileKind::footprints);
    EXPECT_EQ(getKind(R"({"scenes":[],"asset":{"version":"2.0"}})"), FileKind::mesh);
}

TEST(FileKind, ContentCountsNotTheName) {
    EXPECT_EQ(getKind("ply\nformat ascii 1.0\n", "city.geojson"), FileKind::mesh);
    EXPECT_EQ(getKind("# made by hand\n\nmtllib x.mtl\nv 0 0 0\n", "city.txt"), FileKind::mesh);
    EXPECT_EQ(getKind("glTF\2\0\0\0"sv, "x"), FileKind::mesh);
    EXPECT_EQ(getKind("II*\0\10\0\0\0"sv, "x"), FileKind::terrain);
    EXPECT_EQ(getKind("\0\0\x27\x0a\0\0"sv, "x"), FileKind::footprints);
    EXPECT_EQ(getKind("<?xml version='1.0'?>\n<osm version='0.6'>", "x"), FileKind::footprints);
    EXPECT_EQ(getKind("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n", "dem.asc"),
              FileKind::terrain);
}

TEST(FileKind, WhatIsNoCityIsAnErrorWithAdvice) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(detectFileKind(folder.path("missing.json")).error().what, "There is no such file");
    EXPECT_EQ(detectFileKind(folder.file("empty.json", "")).error().what, "The file is empty");
    for (const std::string_view content :
         {"{}"sv, "{"sv, "hello"sv, "{\"type\":"sv, "[1,2]"sv, "\0\0\0\0"sv}) {
        const auto kind = detectFileKind(folder.file("some.dat", content));
        ASSERT_FALSE(kind) << content;
        EXPECT_NE(kind.error().advice.find("CityJSON"), std::string::npos);
    }
}

TEST(FileKind, AFolderThatIsNoDatasetSaysWhatToName) {
    const tests::TemporaryFolder folder;
    (void)folder.file("tile.gml", "<CityModel/>");
    const auto kind = detectFileKind(folder.path(""));
    ASSERT_FALSE(kind);
    EXPECT_EQ(kind.error().what, "This folder is no file geodatabase and holds no Shapefiles");
}

TEST(FileKind, OpenStreetMapPbf) {
    const auto file = tests::sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!file) GTEST_SKIP() << "shared data is missing";
    EXPECT_EQ(detectFileKind(*file).value(), FileKind::footprints);
}

}  // namespace
}  // namespace noonmark
