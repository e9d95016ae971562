#include "core/io/pictures/ground_raster_file.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <fstream>
#include <limits>

#include "core/base/gdal_calls.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Frame frame({4.45, 51.9});
const Box2 aroundOrigin{{-100, -100}, {100, 100}};

class ReadGroundRaster : public testing::Test {
protected:
    ReadGroundRaster() { const GdalCalls prepared; }

    // What a test file holds: 80 x 80 pixels of 2 m around the origin, red in the west, blue in the east.
    struct File {
        std::string crs = frame.projString();
        int bands = 3;
        GDALDataType type = GDT_Byte;
        double westM = -80, northM = 80, pixelM = 2;
        bool placed = true;
        bool indexed = false;
    };

    std::filesystem::path made(const File& wanted) {
        const std::filesystem::path path = folder.path("picture.tif");
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        const GDALDatasetUniquePtr dataset(
            driver->Create(path.c_str(), 80, 80, wanted.bands, wanted.type, nullptr));
        if (wanted.placed) {
            std::array<double, 6> place{wanted.westM, wanted.pixelM, 0, wanted.northM, 0, -wanted.pixelM};
            dataset->SetGeoTransform(place.data());
        }
        OGRSpatialReference system;
        if (!wanted.crs.empty() && system.SetFromUserInput(wanted.crs.c_str()) == OGRERR_NONE) {
            system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
            dataset->SetSpatialRef(&system);
        }
        if (wanted.indexed) setPalette(*dataset);
        for (int band = 1; band <= wanted.bands; ++band) fill(*dataset->GetRasterBand(band), wanted.indexed);
        return path;
    }

    static void setPalette(GDALDataset& dataset) {
        GDALColorTable table;
        const GDALColorEntry green{0, 255, 0, 255}, yellow{255, 255, 0, 255};
        table.SetColorEntry(0, &green);
        table.SetColorEntry(1, &yellow);
        dataset.GetRasterBand(1)->SetColorTable(&table);
    }

    // Band 1 is bright in the west, band 3 in the east; indices are 0 in the west and 1 in the east.
    static void fill(GDALRasterBand& band, bool indexed) {
        for (int column = 0; column < 80; ++column) {
            const bool west = column < 40;
            unsigned char value = indexed ? (west ? 0 : 1) : 0;
            if (!indexed && band.GetBand() == (west ? 1 : 3)) value = 200;
            for (int row = 0; row < 80; ++row)
                EXPECT_EQ(band.RasterIO(GF_Write, column, row, 1, 1, &value, 1, 1, GDT_Byte, 0, 0, nullptr),
                          CE_None);
        }
    }

    static Result<GroundRaster> read(const std::filesystem::path& file, const Box2& box = aroundOrigin,
                                     const GroundRasterSettings& settings = {}) {
        NoProgress progress;
        return readGroundRaster(file, frame, box, settings, progress, {});
    }

    static std::string errorOf(const Result<GroundRaster>& read) {
        return read ? "no error" : read.error().text();
    }

    static std::array<int, 4> colourAt(const GroundRaster& raster, double eastM, double northM) {
        const Grid& grid = raster.grid;
        const std::size_t first =
            4 * grid.index(int((eastM - grid.westM) / grid.cellM), int((northM - grid.southM) / grid.cellM));
        return {raster.rgba[first], raster.rgba[first + 1], raster.rgba[first + 2], raster.rgba[first + 3]};
    }

    tests::TemporaryFolder folder;
};

TEST_F(ReadGroundRaster, ColoursLieWhereTheyBelong) {
    const auto raster = read(made({}));
    ASSERT_TRUE(raster) << errorOf(raster);
    EXPECT_THAT(colourAt(*raster, -40, 50), ElementsAre(200, 0, 0, 255));
    EXPECT_THAT(colourAt(*raster, 40, -50), ElementsAre(0, 0, 200, 255));
    EXPECT_NEAR(raster->grid.westM, -80, 0.1) << "no more than the picture covers";
    EXPECT_NEAR(raster->grid.northM(), 80, 0.2);
}

TEST_F(ReadGroundRaster, OtherProjectionsAreReprojected) {
    // UTM zone 31N of the frame's origin, moved by the file's own box.
    OGRSpatialReference wgs, utm;
    wgs.SetFromUserInput("EPSG:4326");
    utm.SetFromUserInput("EPSG:32631");
    for (OGRSpatialReference* system : {&wgs, &utm})
        system->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> transform(
        OGRCreateCoordinateTransformation(&wgs, &utm));
    double x = 4.45, y = 51.9;
    ASSERT_TRUE(transform->Transform(1, &x, &y));
    const auto raster = read(made({.crs = "EPSG:32631", .westM = x - 80, .northM = y + 80}));
    ASSERT_TRUE(raster) << errorOf(raster);
    EXPECT_THAT(colourAt(*raster, -20, 30), ElementsAre(200, 0, 0, 255));
    EXPECT_THAT(colourAt(*raster, 20, -30), ElementsAre(0, 0, 200, 255));
}

TEST_F(ReadGroundRaster, SidesStayWithinTheLimit) {
    const auto raster = read(made({}), aroundOrigin, {.maxPixels = 100});
    ASSERT_TRUE(raster);
    EXPECT_LE(std::max(raster->grid.columns, raster->grid.rows), 100);
    EXPECT_NEAR(raster->grid.cellM, 1.6, 0.01);
    EXPECT_EQ(raster->rgba.size(), raster->grid.size() * 4);
}

TEST_F(ReadGroundRaster, GreyAndIndexedPicturesAreRead) {
    const auto grey = read(made({.bands = 1}));
    ASSERT_TRUE(grey) << errorOf(grey);
    EXPECT_THAT(colourAt(*grey, -40, 0), ElementsAre(200, 200, 200, 255));
    const auto indexed = read(made({.bands = 1, .indexed = true}));
    ASSERT_TRUE(indexed) << errorOf(indexed);
    EXPECT_THAT(colourAt(*indexed, -40, 0), ElementsAre(0, 255, 0, 255));
    EXPECT_THAT(colourAt(*indexed, 40, 0), ElementsAre(255, 255, 0, 255));
}

TEST_F(ReadGroundRaster, WhatIsNoPictureOfThisPlaceIsRefused) {
    EXPECT_THAT(errorOf(read(folder.path("missing.tif"))), HasSubstr("missing.tif"));
    EXPECT_THAT(errorOf(read(folder.file("text.tif", "not a picture"))), HasSubstr("GeoTIFF"));
    EXPECT_THAT(errorOf(read(made({.type = GDT_Float32}))), HasSubstr("8 bits"));
    EXPECT_THAT(errorOf(read(made({.crs = ""}))), HasSubstr("coordinate reference system"));
    EXPECT_THAT(errorOf(read(made({.placed = false}))), HasSubstr("position"));
    EXPECT_THAT(errorOf(read(made({.westM = 50000}))), HasSubstr("no ground of this city"));
    EXPECT_THAT(errorOf(read(folder.file("virtual.tif", "<VRTDataset rasterXSize=\"1\"/>"))),
                HasSubstr("virtual dataset"));
}

TEST_F(ReadGroundRaster, ADamagedFileIsAnError) {
    const auto file = made({});
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    EXPECT_THAT(errorOf(read(file)), HasSubstr("picture.tif"));
}

TEST_F(ReadGroundRaster, StopsWhenAsked) {
    NoProgress progress;
    std::stop_source stop;
    stop.request_stop();
    const auto raster = readGroundRaster(made({}), frame, aroundOrigin, {}, progress, stop.get_token());
    ASSERT_FALSE(raster);
    EXPECT_TRUE(isCancelled(raster.error()));
}

}  // namespace
}  // namespace noonmark
