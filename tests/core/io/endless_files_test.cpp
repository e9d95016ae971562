#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/base/gdal_calls.h"
#include "core/io/files/file_kind.h"
#include "core/io/files/plain_file.h"
#include "core/io/footprints/read_parcels.h"
#include "core/io/read_part.h"
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

}  // namespace
}  // namespace noonmark
