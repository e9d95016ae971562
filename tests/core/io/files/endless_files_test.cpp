#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include <array>
#include <bit>
#include <vector>

#include "core/base/gdal_calls.h"
#include "core/io/files/geopackage_check.h"
#include "core/io/files/json_nesting.h"
#include "core/io/files/plain_file.h"
#include "core/io/footprints/read_parcels.h"
#include "core/io/meshes/ifc_site.h"
#include "core/io/meshes/stated_axes.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_region.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

bool isRefusedAsPipe(const Error& error) {
    return error.what == "This is a pipe or a device, not a file" && !error.advice.empty();
}

TEST(EndlessFiles, PipesAndDevicesAreRefusedAtOnce) {
    const tests::TemporaryFolder folder;
    const auto pipe = folder.path("city.geojson");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const Frame frame({-73.98, 40.75});
    for (const std::filesystem::path& file : {pipe, std::filesystem::path("/dev/zero")}) {
        EXPECT_TRUE(isRefusedAsPipe(detectFileKind(file).error()));
        EXPECT_TRUE(isRefusedAsPipe(readRegion(file.string(), frame).error()));
        EXPECT_TRUE(isRefusedAsPipe(readParcels(file, {}, frame, {}).error()));
    }
    EXPECT_TRUE(checkPlainFile(folder.file("a", "a")));
    EXPECT_TRUE(checkPlainFile(folder.path("")));
    EXPECT_EQ(checkPlainFile(folder.path("b")).error().what, "There is no such file");
}

std::string cityJson(const std::string& more) {
    return R"({"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},)"
           R"("CityObjects":{},"vertices":[],"more":)" +
           more + "}";
}

// 60 bytes of memory for each bracket: a file of 1 GB would need 60.
TEST(EndlessFiles, CityJsonNestedWithoutEndIsRefused) {
    const tests::TemporaryFolder folder;
    NoProgress quiet;
    const auto deep =
        readCityJson(folder.file("deep.city.json", cityJson(std::string(100'000, '['))), {}, quiet, {});
    ASSERT_FALSE(deep);
    EXPECT_NE(deep.error().what.find("nested more than 500 deep"), std::string::npos) << deep.error().text();
    EXPECT_EQ(deep.error().kind, ErrorKind::limit);
    // Of a sequence, a line beyond the first piece that is read is left out alone.
    const auto line =
        readCityJson(folder.file("deep.city.jsonl", cityJson("0") + "\n" + std::string(70'000, ' ') + "\n" +
                                                        std::string(100'000, '[') + "\n"),
                     {}, quiet, {});
    ASSERT_FALSE(line);
    EXPECT_EQ(line.error().what.find("nested"), std::string::npos) << line.error().text();
}

TEST(EndlessFiles, BracketsInTextsAreNoLevels) {
    const std::string brackets(2 * JsonNesting::maxLevels, '[');
    EXPECT_TRUE(JsonNesting().take("{\"a\":\"" + brackets + "\"}"));
    EXPECT_TRUE(JsonNesting().take("{\"a\\\"" + brackets + "\":1}")) << "an escaped quotation mark";
    EXPECT_FALSE(JsonNesting().take("{\"a\\\\\":" + brackets)) << "an escaped backslash";
    JsonNesting pieces;
    EXPECT_TRUE(pieces.take(brackets.substr(0, JsonNesting::maxLevels)));
    EXPECT_FALSE(pieces.take("["));
    EXPECT_FALSE(pieces.take("]")) << "it stays refused";
}

// The header of a drawing is read in the program's own process, before the library's process has any.
TEST(EndlessFiles, ALineWithoutEndEndsTheHeaderOfADrawing) {
    const tests::TemporaryFolder folder;
    const std::string unit = "9\n$INSUNITS\n70\n4\n";
    const auto axesOf = [&](const std::string& between) {
        return findStatedAxes(folder.file("a.dxf", "0\nSECTION\n2\nHEADER\n" + between + unit)).value();
    };
    EXPECT_EQ(axesOf("1\n" + std::string(60'000, 'x') + "\n").metresPerUnit, 0.001);
    EXPECT_EQ(axesOf("1\n" + std::string(70'000, 'x') + "\n").metresPerUnit, std::nullopt);
}

// Units and directions without end, with names without end.
TEST(EndlessFiles, StatementsOfAnIfcAreNotCollectedWithoutEnd) {
    const tests::TemporaryFolder folder;
    std::string text = "ISO-10303-21;\nFILE_SCHEMA(('IFC4'));\n";
    text += "#" + std::string(3000, '1') + "=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);\n";
    text += "#2=IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.);\n";
    text += "#3=IFCMEASUREWITHUNIT(IFCLENGTHMEASURE(1.E300),#2);\n";
    text += "#4=IFCCONVERSIONBASEDUNIT(#9,.LENGTHUNIT.,'LEAGUE',#3);\n#5=IFCUNITASSIGNMENT((#4));\n";
    text += "#6=IFCSITE('2',$,'site',$,$,#15,$,$,.ELEMENT.,(50,43,30),(7,6,0),1.E300,$,$);\n";
    const auto file = folder.file("a.ifc", text);
    EXPECT_EQ(findStatedAxes(file)->metresPerUnit, 1) << "no unit is so long";
    EXPECT_EQ(readIfcSite(file, {}).elevationM, std::nullopt);
    EXPECT_TRUE(readIfcSite(file, {}).place);
}

std::string terrainError(const std::filesystem::path& file) {
    ReadSettings settings;
    settings.crs = "EPSG:4326";
    NoProgress progress;
    const auto piece = readTerrain(file, settings, progress, {});
    return piece ? "" : piece.error().text();
}

TEST(EndlessFiles, AnAsciiGridThatPromisesMoreThanItHoldsIsRefused) {
    const tests::TemporaryFolder folder;
    const auto grid = [](const std::string& columns, const std::string& rows) {
        std::string text = "ncols " + columns + "\nnrows " + rows +
                           "\nxllcorner -74\nyllcorner 40\ncellsize 0.0001\nNODATA_value -9999\n";
        for (int i = 0; i < 20; ++i) text += i % 5 == 4 ? "1\n" : "1 ";
        return text;
    };
    EXPECT_EQ(terrainError(folder.file("good.asc", grid("5", "4"))), "");
    for (const auto& [columns, rows] : {std::pair("5", "1000000000"), std::pair("5", "4000"),
                                        std::pair("1000000000", "4"), std::pair("2000000000", "2000000000")})
        EXPECT_NE(terrainError(folder.file("bad.asc", grid(columns, rows))), "") << columns << ' ' << rows;
    EXPECT_NE(terrainError(folder.file("bad.asc", grid("5", "4000"))).find("more than the file holds"),
              std::string::npos);
}

TEST(EndlessFiles, ARasterOfTooManyCellsIsRefusedWithItsLimit) {
    const tests::TemporaryFolder folder;
    const auto file = folder.path("sparse.tif");
    {
        const GdalCalls calls;
        const char* const options[] = {"SPARSE_OK=YES",   "TILED=YES",       "BIGTIFF=YES",
                                       "BLOCKXSIZE=4096", "BLOCKYSIZE=4096", nullptr};
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        const GDALDatasetUniquePtr made(
            driver->Create(file.c_str(), 200000, 200000, 1, GDT_Float32, const_cast<char**>(options)));
        ASSERT_TRUE(made);
        double place[6] = {-74, 1e-6, 0, 40.8, 0, -1e-6};
        made->SetGeoTransform(place);
    }
    const std::string error = terrainError(file);
    EXPECT_NE(error.find("200000 x 200000 cells"), std::string::npos) << error;
    EXPECT_NE(error.find("Cut out"), std::string::npos) << error;
}

// A TIFF of one tile, whose side is stated and which the file does not hold.
std::string tiffOfOneTile(std::uint32_t side) {
    std::string bytes("II*\0\x08\0\0\0", 8);
    const auto put = [&](std::uint64_t value, int size) {
        for (int i = 0; i < size; ++i) bytes += char(value >> (8 * i));
    };
    const std::vector<std::array<std::uint32_t, 4>> entries{
        {256, 4, 1, 200}, {257, 4, 1, 200},    {258, 3, 1, 32},     {259, 3, 1, 1},     {262, 3, 1, 1},
        {277, 3, 1, 1},   {322, 4, 1, side},   {323, 4, 1, side},   {324, 4, 1, 8},     {325, 4, 1, 16},
        {339, 3, 1, 3},   {33550, 12, 3, 182}, {33922, 12, 6, 206}, {34735, 3, 16, 254}};
    put(entries.size(), 2);
    for (const auto& [tag, type, count, value] : entries)
        put(tag, 2), put(type, 2), put(count, 4), put(value, 4);
    put(0, 4);
    for (const double number : {1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 583000.0, 4507000.0, 0.0})
        put(std::bit_cast<std::uint64_t>(number), 8);
    for (const int key : {1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 32618})
        put(std::uint64_t(key), 2);
    return bytes;
}

TEST(EndlessFiles, ARasterOfHugeBlocksIsRefusedWithItsLimit) {
    const tests::TemporaryFolder folder;
    const std::string text = tiffOfOneTile(65536);
    EXPECT_EQ(text.size(), 286U);
    const std::string error = terrainError(folder.file("tiles.tif", text));
    EXPECT_NE(error.find("blocks of 65536 x 65536 cells, more than 256 MB"), std::string::npos) << error;
    EXPECT_EQ(terrainError(folder.file("tile.tif", tiffOfOneTile(256))).find("blocks of"), std::string::npos);
}

TEST(EndlessFiles, AValueOfMoreThan100MegabytesOfAGeoPackageIsRefused) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(":memory:", &database), SQLITE_OK);
    limitGeoPackage(database);
    EXPECT_EQ(sqlite3_exec(database, "SELECT zeroblob(99000000)", nullptr, nullptr, nullptr), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database, "SELECT zeroblob(101000000)", nullptr, nullptr, nullptr), SQLITE_TOOBIG);
    constexpr const char* endless =
        "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x FROM n) SELECT count(*) FROM n";
    std::stop_source stop;
    stop.request_stop();
    const GdalCalls calls(stop.get_token());
    EXPECT_EQ(sqlite3_exec(database, endless, nullptr, nullptr, nullptr), SQLITE_INTERRUPT);
    sqlite3_close(database);
}

}  // namespace
}  // namespace noonmark
