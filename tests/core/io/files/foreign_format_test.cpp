#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/files/plain_file.h"
#include "core/io/formats/format.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using namespace std::string_view_literals;
using testing::HasSubstr;

struct Foreign {
    const char* file;
    std::string_view content;
    const char* name;
    const char* remedy;
};

TEST(ForeignFormat, IsRefusedByItsNameWithWhatToDo) {
    const std::string tar = "town.geojson" + std::string(245, '\0') + "ustar";
    const Foreign files[] = {
        {"a.epw", "LOCATION,Chicago Ohare Intl Ap,IL,USA,TMY3,725300,41.98,-87.92,-6.0,201.0\n", "EPW",
         "needs no weather"},
        {"a.las", "LASF\0\0"sv, "LAS or LAZ", "PDAL"},
        {"a.laz", "LASF\0\0"sv, "LAS or LAZ", "GeoTIFF"},
        {"a.parquet", "PAR1\x15\4"sv, "Parquet", "GeoPackage"},
        {"a.tab", "!table\n!version 300\n", "MapInfo", "GeoPackage"},
        {"a.mif", "Version 300\nCharset \"Neutral\"\nColumns 1\n", "MapInfo", "GeoPackage"},
        {"tileset.json", R"({"asset":{"version":"1.0"},"geometricError":500,"root":{}})", "3D Tiles",
         "CityJSON"},
        {"a.b3dm", "b3dm\1\0\0\0"sv, "3D Tiles", "CityJSON"},
        {"a.dwg", "AC1032\0\0"sv, "DWG", "DXF"},
        {"a.skp", "\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0 \0M\0o\0d\0e\0l\0"sv, "SketchUp", "glTF"},
        {"a.3dm", "3D Geometry File Format        5", "3DM", "OBJ"},
        {"a.fbx", "Kaydara FBX Binary  \0"sv, "FBX", "glTF"},
        {"a.csv", "\xFF\xFEi\0d\0;\0"sv, "UTF-16", "UTF-8"},
        {"a.ods", "PK\3\4"sv, "OpenDocument", "CSV"},
        {"a.3mf", "PK\3\4"sv, "3MF", "OBJ"},
        {"a.jml", "<?xml version='1.0'?><JCSDataFile xmlns:gml='http://www.opengis.net/gml'>", "OpenJUMP",
         "GeoPackage"},
        {"a.ifczip", "PK\3\4"sv, "IFC in a ZIP", "Unpack"},
        {"a.tar", tar, "tar", "Unpack"},
        {"a.dbf", "\3\x7C"sv, "Shapefile", ".shp"},
        {"a.png", "\x89PNG"sv, "PNG", "GeoTIFF"},
        {"a.stp", "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));", "STEP", "IFC"},
    };
    const tests::TemporaryFolder folder;
    for (const Foreign& foreign : files) {
        const auto kind = detectFileKind(folder.file(foreign.file, foreign.content));
        ASSERT_FALSE(kind) << foreign.file;
        EXPECT_THAT(kind.error().what, HasSubstr(foreign.name)) << foreign.file;
        EXPECT_THAT(kind.error().advice, HasSubstr(foreign.remedy)) << foreign.file;
        EXPECT_EQ(kind.error().kind, ErrorKind::unsupported) << foreign.file;
    }
}

TEST(ForeignFormat, WhatIsReadIsNot) {
    const tests::TemporaryFolder folder;
    for (const std::string_view content :
         {"ISO-10303-21;\nFILE_SCHEMA(('IFC4'));"sv, R"({"asset":{"version":"2.0"}})"sv,
          "<kml><Document/></kml>"sv, "<osm version='0.6'>"sv, "v 0 0 0\n"sv, "II*\0"sv, "hello"sv, ""sv})
        EXPECT_TRUE(refuseForeignFormat(folder.file("a", content))) << content;
    EXPECT_TRUE(refuseForeignFormat(folder.file("N48W122.hgt", "\xFF\xD8\xFF\xE0"sv))) << "-40 m and -32 m";
    EXPECT_TRUE(refuseForeignFormat(folder.path("missing")));
    EXPECT_TRUE(refuseForeignFormat(folder.path("")));
}

TEST(ForeignFormat, PublishedWeatherIsRecognised) {
    const auto path = tests::sharedData("world/chicago.epw");
    if (!path) GTEST_SKIP() << "shared data is missing";
    const auto kind = detectFileKind(*path);
    ASSERT_FALSE(kind);
    EXPECT_THAT(kind.error().text(), HasSubstr("EPW"));
}

}  // namespace
}  // namespace noonmark
