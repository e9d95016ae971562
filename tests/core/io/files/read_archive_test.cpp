#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <iterator>

#include "core/io/archives/unpack_archive.h"
#include "core/io/read_city.h"
#include "tests/core/io/citygml_fixtures.h"
#include "tests/core/io/terrain_files.h"
#include "tests/core/io/zip_files.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using testing::HasSubstr;
using tests::cityGml;
using tests::gmlBoxSolid;
using tests::gmlBuilding;
using tests::sharedData;
using tests::TemporaryFolder;
using tests::ZipMaker;

constexpr const char* packedSquare =
    R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"height":9},"geometry":)"
    R"({"type":"Polygon","coordinates":[[[-73.98,40.75],[-73.979,40.75],[-73.979,40.751],[-73.98,40.75]]]}}]})";

std::string allBytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string gzipped(const std::string& content, const TemporaryFolder& folder) {
    const auto file = folder.path("made.gz");
    gzFile packed = gzopen(file.c_str(), "wb");
    gzwrite(packed, content.data(), unsigned(content.size()));
    gzclose(packed);
    return allBytesOf(file);
}

class ReadArchive : public testing::Test {
protected:
    Result<CityRead> readBytes(const std::string& name, const std::string& bytes) {
        NoProgress quiet;
        return readCity({folder.file(name, bytes)}, {}, quiet, {});
    }
    void expectRefused(const std::string& bytes, const char* why) {
        const auto city = readBytes("city.zip", bytes);
        ASSERT_FALSE(city) << why;
        EXPECT_THAT(city.error().text(), HasSubstr(why));
        EXPECT_THAT(city.error().text(), HasSubstr("city.zip"));
    }
    TemporaryFolder folder;
};

TEST_F(ReadArchive, ACityIsReadInPlace) {
    ZipMaker zip;
    zip.add("readme.txt", "hello");
    zip.add("data/square.geojson", packedSquare);
    for (const auto& [name, bytes] : {std::pair<std::string, std::string>("city.zip", zip.text()),
                                      {"square.geojson.gz", gzipped(packedSquare, folder)},
                                      {"unnamed", gzipped(packedSquare, folder)}}) {
        const auto city = readBytes(name, bytes);
        ASSERT_TRUE(city) << name << ": " << city.error().text();
        EXPECT_EQ(city->city.buildings.size(), 1U) << name;
    }
}

TEST_F(ReadArchive, ArchivesInArchivesAreReadTwoDeep) {
    ZipMaker kmz, zip, outermost;
    kmz.add("doc.kml",
            "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark><Polygon><extrude>1</extrude>"
            "<altitudeMode>relativeToGround</altitudeMode><outerBoundaryIs><LinearRing><coordinates>"
            "8,50,17 8.001,50,17 8.001,50.001,17 8,50,17</coordinates></LinearRing></outerBoundaryIs>"
            "</Polygon></Placemark></Document></kml>");
    EXPECT_EQ(readBytes("city.kmz", kmz.text())->city.buildings.size(), 1U);
    zip.add("city.kmz", kmz.text());
    EXPECT_EQ(readBytes("city.zip", zip.text())->city.buildings.size(), 1U);
    outermost.add("city.zip", zip.text());
    expectRefused(outermost.text(), "no file of a format that is read");
}

TEST_F(ReadArchive, AShapefileIsReadWithItsTable) {
    const auto shape = sharedData("world/aveyron/BATIMENT.shp");
    if (!shape) GTEST_SKIP() << "shared data is missing";
    ZipMaker zip;
    for (const char* ending : {".shp", ".dbf", ".shx", ".prj"})
        zip.add("aveyron/BATIMENT" + std::string(ending),
                allBytesOf(std::filesystem::path(*shape).replace_extension(ending)));
    const auto city = readBytes("aveyron.zip", zip.text());
    ASSERT_TRUE(city) << city.error().text();
    EXPECT_EQ(city->city.buildings.size(), 2273U);
}

TEST_F(ReadArchive, SeveralCityModelsAreTilesOfOneCity) {
    ZipMaker zip;
    for (int i = 0; i < 3; ++i)
        zip.add(fmt::format("tile{}.gml", i),
                cityGml(gmlBuilding(fmt::format("b{}", i),
                                    gmlBoxSolid({30 * i, 0, 0}, {30 * i + 10, 10, 5 + i}))));
    const auto city = readBytes("tiles.zip", zip.text());
    ASSERT_TRUE(city) << city.error().text();
    ASSERT_EQ(city->city.buildings.size(), 3U);
    EXPECT_NEAR(bounds(*city->city.buildings[2]).low.x - bounds(*city->city.buildings[0]).low.x, 60, 0.5);
}

TEST_F(ReadArchive, AMeshIsReadInPlace) {
    ZipMaker zip;
    zip.add("model/tower.obj",
            "o tower\nv 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 0 0 30\nv 9 0 30\nv 9 9 30\nv 0 9 30\n"
            "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    NoProgress quiet;
    const ReadSettings settings{.meshAnchor = LonLat{8, 50}};
    const auto city = readCity({folder.file("mesh.zip", zip.text())}, settings, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    ASSERT_EQ(city->city.buildings.size(), 1U);
    EXPECT_NEAR(topM(*city->city.buildings[0]), 30, 1e-3);
    expectRefused(zip.text(), "has no position");
}

TEST_F(ReadArchive, TerrainIsReadInPlace) {
    const auto raster =
        tests::writeTerrain(folder.path("dem.tif"), {-73.9795, 40.7505}, [](double, double) { return 12; });
    ZipMaker zip;
    zip.add("dem.tif", allBytesOf(raster));
    NoProgress quiet;
    const auto city = readCity(
        {folder.file("square.geojson", packedSquare), folder.file("dem.zip", zip.text())}, {}, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    ASSERT_TRUE(city->city.terrain);
    EXPECT_EQ(city->city.buildings.size(), 1U);
}

TEST_F(ReadArchive, ShapefilesOfOneFolderAreLayersOfOneMap) {
    const auto shape = sharedData("world/aveyron/BATIMENT.shp");
    if (!shape) GTEST_SKIP() << "shared data is missing";
    ZipMaker zip;
    for (const char* name : {"a", "b"})
        for (const char* ending : {".shp", ".dbf", ".shx", ".prj"})
            zip.add(std::string("maps/") + name + ending,
                    allBytesOf(std::filesystem::path(*shape).replace_extension(ending)));
    const auto city = readBytes("maps.zip", zip.text());
    ASSERT_TRUE(city) << city.error().text();
    EXPECT_EQ(city->city.buildings.size(), 2273U) << "those that are there twice count once";
}

TEST_F(ReadArchive, TreesOfAMapComeWithIt) {
    constexpr const char* street =
        "<osm version='0.6'><node id='1' lat='40.75' lon='-73.98'/><node id='2' lat='40.75' lon='-73.9798'/>"
        "<node id='3' lat='40.7502' lon='-73.98'/><node id='4' lat='40.7504' lon='-73.98'>"
        "<tag k='natural' v='tree'/><tag k='height' v='12'/></node><way id='1'><nd ref='1'/><nd ref='2'/>"
        "<nd ref='3'/><nd ref='1'/><tag k='building' v='yes'/><tag k='height' v='9'/></way></osm>";
    const auto city = readBytes("street.osm.gz", gzipped(street, folder));
    ASSERT_TRUE(city) << city.error().text();
    ASSERT_TRUE(city->city.trees);
    ASSERT_EQ(city->city.trees->trees.size(), 1U);
    EXPECT_EQ(city->city.trees->trees[0].heightM, 12);
}

// A block of 5 x 5 cells whose middle no elevation is known of, on level ground.
TEST_F(ReadArchive, HolesOfASurfaceStayHoles) {
    constexpr const char* head =
        "ncols 13\nnrows 13\nxllcorner 391800\nyllcorner 5819500\ncellsize 4\nNODATA_value -9999\n";
    std::string surface = head, ground = head;
    for (int row = 0; row < 13; ++row)
        for (int column = 0; column < 13; ++column) {
            const int far = std::max(std::abs(row - 6), std::abs(column - 6));
            surface += far == 0 ? "-9999 " : far <= 2 ? "52.5 " : "40.5 ";
            ground += "40.5 ";
        }
    ZipMaker zip;
    zip.add("dsm.asc", surface);
    NoProgress quiet;
    for (const auto& dsm : {folder.file("dsm.asc", surface), folder.file("dsm.zip", zip.text())}) {
        const auto city = readCity({dsm, folder.file("dtm.asc", ground)}, {.crs = "EPSG:25833"}, quiet, {});
        ASSERT_TRUE(city) << city.error().text();
        double areaM2 = 0;
        for (const auto& building : city->city.buildings)
            for (const Part& part : building->parts) areaM2 += area(part.footprint);
        EXPECT_NEAR(areaM2, 24 * 16, 1) << dsm;
    }
}

TEST_F(ReadArchive, WhatIsNotReadIsNamedWithWhatToDo) {
    ZipMaker zip;
    zip.add("readme.txt", "hello");
    zip.add("scan/points.las", "LASF" + std::string(300, '\0'));
    expectRefused(zip.text(), "\"points.las\": this is LAS or LAZ, a point cloud, which is not read");
    expectRefused(zip.text(), "Make a GeoTIFF of its ground points");
}

TEST_F(ReadArchive, SeveralFilesThatAreNoTilesAreNamed) {
    ZipMaker zip;
    zip.add("houses.geojson", packedSquare);
    zip.add("roads.geojson", packedSquare);
    expectRefused(zip.text(), "2 files that could be the city: houses.geojson, roads.geojson");
}

TEST_F(ReadArchive, NothingIsWrittenOutsideOfItsFolder) {
    for (const char* name : {"../evil.geojson", "/tmp/noonmark-evil.geojson", "a/../../evil.geojson",
                             "..\\evil.geojson", "C:evil.geojson"}) {
        ZipMaker zip;
        zip.add(name, packedSquare);
        expectRefused(zip.text(), "outside of its own folder");
    }
    EXPECT_FALSE(std::filesystem::exists("/tmp/noonmark-evil.geojson"));
}

TEST_F(ReadArchive, ABombIsRefusedBeforeItHasGrown) {
    const std::string zeros(100'000'000, ' ');
    const std::string gzip = gzipped(zeros, folder);
    expectRefused(gzip, "grows to more than 200 times its size");
    ZipMaker zip;
    for (int i = 0; i < 12; ++i) zip.add(fmt::format("{}.txt", i), "hello");
    const auto unpacked = unpackArchive(folder.file("many.zip", zip.text()), {}, {.files = 10});
    ASSERT_FALSE(unpacked);
    EXPECT_THAT(unpacked.error().text(), HasSubstr("more than 10 files"));
    const auto large = unpackArchive(folder.file("many.zip", zip.text()), {}, {.bytes = 12});
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().kind, ErrorKind::limit);
}

TEST_F(ReadArchive, DamagedAndEncryptedArchivesAreRefused) {
    ZipMaker good;
    good.add("square.geojson", packedSquare);
    std::string wrong = good.text();
    wrong[wrong.find("height")] = 'H';
    expectRefused(wrong, "damaged");
    for (std::size_t length = 4; length < good.text().size(); length += 29)
        expectRefused(good.text().substr(0, length), "damaged or cut off");
    const std::string gzip = gzipped(packedSquare, folder);
    expectRefused(gzip.substr(0, gzip.size() / 2), "damaged or cut off");
    ZipMaker secret;
    secret.add("square.geojson", packedSquare, 1);
    expectRefused(secret.text(), "encrypted");
    expectRefused(ZipMaker().text(), "");
}

TEST_F(ReadArchive, NothingIsLeftBehind) {
    const TemporaryFolder temporary;
    setenv("TMPDIR", temporary.path("").c_str(), 1);
    ZipMaker zip;
    zip.add("square.geojson", packedSquare);
    EXPECT_TRUE(readBytes("city.zip", zip.text()));
    unsetenv("TMPDIR");
    EXPECT_THAT(temporary.names(), testing::IsEmpty());
}

TEST_F(ReadArchive, AStopEndsTheUnpacking) {
    std::stop_source source;
    source.request_stop();
    ZipMaker zip;
    zip.add("square.geojson", packedSquare);
    const auto unpacked = unpackArchive(folder.file("city.zip", zip.text()), source.get_token());
    ASSERT_FALSE(unpacked);
    EXPECT_TRUE(isCancelled(unpacked.error()));
}

}  // namespace
}  // namespace noonmark
