#include "core/io/write_raster.h"
#include "core/base/gdal_calls.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

class WriteRaster : public testing::Test {
protected:
    WriteRaster() { const GdalCalls prepared; }

    GDALDatasetUniquePtr opened(const std::filesystem::path& file) {
        return GDALDatasetUniquePtr(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
    }
    static float valueAt(GDALRasterBand& band, int column, int row) {
        float value = 0;
        EXPECT_EQ(band.RasterIO(GF_Read, column, row, 1, 1, &value, 1, 1, GDT_Float32, 0, 0, nullptr),
                  CE_None);
        return value;
    }

    tests::TemporaryFolder folder;
};

TEST_F(WriteRaster, FirstRowOfTheFileIsTheNorthernmost) {
    const Grid grid{-30, 50, 2, 3, 2};
    const std::vector<float> gross{1, 2, 3, 4, nothing, 6};
    const std::vector<float> longest{10, 20, 30, 40, 50, 60};
    ASSERT_TRUE(writeGeoTiff(folder.path("map.tif"), Frame({-73.98, 40.75}), grid,
                             {{"gross shadow", "min/day", &gross}, {"continuous shadow", "min", &longest}}));
    const auto dataset = opened(folder.path("map.tif"));
    ASSERT_TRUE(dataset);
    std::array<double, 6> corner{};
    dataset->GetGeoTransform(corner.data());
    EXPECT_THAT(corner, ElementsAre(-30, 2, 0, 54, 0, -2));
    ASSERT_EQ(dataset->GetRasterCount(), 2);
    GDALRasterBand& first = *dataset->GetRasterBand(1);
    EXPECT_EQ(valueAt(first, 0, 0), 4);
    EXPECT_TRUE(std::isnan(valueAt(first, 1, 0)));
    EXPECT_EQ(valueAt(first, 0, 1), 1);
    EXPECT_EQ(valueAt(*dataset->GetRasterBand(2), 2, 1), 30);
}

TEST_F(WriteRaster, TheFileCarriesItsTags) {
    const std::vector<float> values{1, 2, 3, 4};
    ASSERT_TRUE(writeGeoTiff(folder.path("map.tif"), Frame({0, 0}), Grid{0, 0, 1, 2, 2},
                             {{"gross shadow", "min/day", &values}},
                             {{"NOONMARK_SCENARIO", "Höher & breiter"}, {"NOONMARK_EDITS", "one\ntwo"}}));
    const auto dataset = opened(folder.path("map.tif"));
    EXPECT_STREQ(dataset->GetMetadataItem("NOONMARK_SCENARIO"), "Höher & breiter");
    EXPECT_STREQ(dataset->GetMetadataItem("NOONMARK_EDITS"), "one\ntwo");
}

TEST_F(WriteRaster, BandsCarryNameUnitAndNoData) {
    const Grid grid{0, 0, 1, 2, 2};
    const std::vector<float> values{1, 2, 3, 4};
    ASSERT_TRUE(
        writeGeoTiff(folder.path("map.tif"), Frame({0, 0}), grid, {{"gross shadow", "min/day", &values}}));
    const auto dataset = opened(folder.path("map.tif"));
    GDALRasterBand& band = *dataset->GetRasterBand(1);
    EXPECT_STREQ(band.GetDescription(), "gross shadow");
    EXPECT_STREQ(band.GetUnitType(), "min/day");
    EXPECT_EQ(band.GetRasterDataType(), GDT_Float32);
    int hasNoData = 0;
    EXPECT_TRUE(std::isnan(band.GetNoDataValue(&hasNoData)));
    EXPECT_TRUE(hasNoData);
}

TEST_F(WriteRaster, IsTiledCompressedAndHasOverviews) {
    const Grid grid{0, 0, 1, 700, 1100};
    const std::vector<float> values(grid.size(), 5);
    ASSERT_TRUE(
        writeGeoTiff(folder.path("map.tif"), Frame({0, 0}), grid, {{"gross shadow", "min/day", &values}}));
    const auto dataset = opened(folder.path("map.tif"));
    GDALRasterBand& band = *dataset->GetRasterBand(1);
    int tileColumns = 0;
    int tileRows = 0;
    band.GetBlockSize(&tileColumns, &tileRows);
    EXPECT_EQ(tileColumns, 256);
    EXPECT_EQ(tileRows, 256);
    EXPECT_STREQ(dataset->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"), "DEFLATE");
    EXPECT_STREQ(dataset->GetMetadataItem("PREDICTOR", "IMAGE_STRUCTURE"), "2");
    ASSERT_EQ(band.GetOverviewCount(), 3);
    EXPECT_EQ(band.GetOverview(2)->GetYSize(), 138);
    EXPECT_EQ(valueAt(*band.GetOverview(2), 40, 60), 5);
}

// The file's CRS, as GIS programs interpret it, against the project's own frame.
class WriteRasterCrs : public WriteRaster, public testing::WithParamInterface<LonLat> {};

TEST_P(WriteRasterCrs, PixelsLieWhereTheFrameSaysTo1Centimetre) {
    const Frame frame(GetParam());
    const Grid grid{-5000, -5000, 10, 1000, 1000};
    const std::vector<float> values(grid.size(), 1);
    ASSERT_TRUE(writeGeoTiff(folder.path("map.tif"), frame, grid, {{"gross shadow", "min/day", &values}}));
    const auto dataset = opened(folder.path("map.tif"));
    const OGRSpatialReference* plane = dataset->GetSpatialRef();
    ASSERT_NE(plane, nullptr);
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> toLonLat(
        OGRCreateCoordinateTransformation(plane, &wgs84));
    ASSERT_TRUE(toLonLat);
    std::array<double, 6> corner{};
    dataset->GetGeoTransform(corner.data());
    for (int row = 0; row < grid.rows; row += 111)
        for (int column = 0; column < grid.columns; column += 111) {
            double x = corner[0] + (column + 0.5) * corner[1];
            double y = corner[3] + (grid.rows - 1 - row + 0.5) * corner[5];
            ASSERT_TRUE(toLonLat->Transform(1, &x, &y));
            const glm::dvec2 seen = frame.localFromLonLat({x, y});
            const glm::dvec2 meant = grid.centre(column, row);
            EXPECT_LT(std::hypot(seen.x - meant.x, seen.y - meant.y), 0.01) << column << ' ' << row;
        }
}

INSTANTIATE_TEST_SUITE_P(Origins, WriteRasterCrs,
                         testing::Values(LonLat{-73.98, 40.75}, LonLat{15.6, 78.2}, LonLat{179.99, -16.8},
                                         LonLat{0, 0}, LonLat{30, -77.8}, LonLat{-58.123456789, -34.6}));

TEST_F(WriteRaster, LeavesNothingElseInTheFolder) {
    const Grid grid{0, 0, 1, 1000, 1000};
    const std::vector<float> values(grid.size(), 5);
    ASSERT_TRUE(writeGeoTiff(folder.path("map.tif"), Frame({0, 0}), grid, {{"a", "b", &values}}));
    ASSERT_TRUE(writeGeoTiff(folder.path("map.tif"), Frame({0, 0}), grid, {{"a", "b", &values}}));
    EXPECT_THAT(folder.names(), ElementsAre("map.tif"));
}

TEST_F(WriteRaster, AFailureKeepsTheOldFile) {
    std::filesystem::create_directory(folder.path("map.tif"));
    (void)folder.file("map.tif/keep", "old");
    const Grid grid{0, 0, 1, 2, 2};
    const std::vector<float> values(grid.size(), 5);
    const auto written = writeGeoTiff(folder.path("map.tif"), Frame({0, 0}), grid, {{"a", "b", &values}});
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), HasSubstr("map.tif"));
    EXPECT_THAT(folder.names(), ElementsAre("map.tif"));
    EXPECT_TRUE(std::filesystem::exists(folder.path("map.tif/keep")));
}

TEST_F(WriteRaster, SaysWhereItCannotWrite) {
    const Grid grid{0, 0, 1, 2, 2};
    const std::vector<float> values(grid.size(), 5);
    const auto written =
        writeGeoTiff(folder.path("no/such/map.tif"), Frame({0, 0}), grid, {{"a", "b", &values}});
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), HasSubstr("no/such/map.tif"));
}

TEST_F(WriteRaster, RefusesABandOfAnotherSize) {
    const std::vector<float> values(3, 5);
    EXPECT_FALSE(
        writeGeoTiff(folder.path("map.tif"), Frame({0, 0}), Grid{0, 0, 1, 2, 2}, {{"a", "b", &values}}));
    EXPECT_FALSE(
        writeGeoTiff(folder.path("map.tif"), Frame({0, 0}), Grid{0, 0, 1, 2, 2}, {{"a", "b", nullptr}}));
    EXPECT_TRUE(folder.names().empty());
}

TEST_F(WriteRaster, PieceByPieceIsTheSameAsAtOnce) {
    const Grid grid{-30, 50, 1, 700, 610};
    std::vector<float> gross(grid.size()), longest(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i) {
        gross[i] = i % 7 == 0 ? nothing : float(i % 360);
        longest[i] = float(i % 91);
    }
    const std::vector<RasterBand> bands{{"gross shadow", "min/day", &gross},
                                        {"continuous shadow", "min", &longest}};
    auto writer = GeoTiffWriter::create(folder.path("map.tif"), Frame({-73.98, 40.75}), grid, bands);
    ASSERT_TRUE(writer);
    for (const auto& [firstRow, endRow] : {std::pair{0, 98}, std::pair{98, 610}}) {
        const Grid part{-30, 50.0 + firstRow, 1, 700, endRow - firstRow};
        const auto from = std::ptrdiff_t(grid.index(0, firstRow)), to = std::ptrdiff_t(grid.index(0, endRow));
        const std::vector<float> a(gross.begin() + from, gross.begin() + to);
        const std::vector<float> b(longest.begin() + from, longest.begin() + to);
        ASSERT_TRUE(writer->write(part, {&a, &b}));
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path("map.tif")));
    ASSERT_TRUE(writer->finish());
    const auto read = readGeoTiff(folder.path("map.tif"), grid);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->at(1), longest);
    for (std::size_t i = 0; i < grid.size(); ++i)
        ASSERT_TRUE(read->at(0)[i] == gross[i] || (std::isnan(read->at(0)[i]) && std::isnan(gross[i])));
    EXPECT_EQ(opened(folder.path("map.tif"))->GetRasterBand(1)->GetOverviewCount(), 2);
    EXPECT_FALSE(readGeoTiff(folder.path("map.tif"), {0, 0, 1, 10, 10}));
    EXPECT_FALSE(readGeoTiff(folder.path("none.tif"), grid));
}

}  // namespace
}  // namespace noonmark
