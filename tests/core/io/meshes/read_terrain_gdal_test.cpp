#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <functional>
#include <memory>

#include "core/base/gdal_calls.h"
#include "core/geo/frame.h"
#include "core/io/pieces/read_part.h"
#include "tests/core/io/piece_checks.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using tests::warns;

// A raster in UTM zone 18 north around Midtown Manhattan with values that are a function of easting and
// northing.
struct Raster {
    int size = 60;
    double pixelM = 10;
    double west = 585000;
    double north = 4512000;
    int epsg = 32618;
    GDALDataType type = GDT_Float32;
    int bands = 1;
    double noData = NAN;
    std::string unit;
    double scale = 1;
    double offset = 0;
    std::function<double(double, double)> value = [](double e, double n) {
        return 300 + (e - 585300) + 0.5 * (n - 4511700);
    };
};

void fill(GDALRasterBand& band, const Raster& raster) {
    std::vector<double> row(std::size_t(raster.size));
    for (int y = 0; y < raster.size; ++y) {
        for (int x = 0; x < raster.size; ++x)
            row[std::size_t(x)] = raster.value(raster.west + (x + 0.5) * raster.pixelM,
                                               raster.north - (y + 0.5) * raster.pixelM);
        ASSERT_EQ(band.RasterIO(GF_Write, 0, y, raster.size, 1, row.data(), raster.size, 1, GDT_Float64, 0, 0,
                                nullptr),
                  CE_None);
    }
    if (!std::isnan(raster.noData)) band.SetNoDataValue(raster.noData);
    if (!raster.unit.empty()) band.SetUnitType(raster.unit.c_str());
    if (raster.scale != 1) band.SetScale(raster.scale);
    if (raster.offset != 0) band.SetOffset(raster.offset);
}

std::filesystem::path written(const tests::TemporaryFolder& folder, const Raster& raster) {
    const GdalCalls prepared;
    const auto path = folder.path("terrain.tif");
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    GDALDatasetUniquePtr dataset(
        driver->Create(path.string().c_str(), raster.size, raster.size, raster.bands, raster.type, nullptr));
    double transform[] = {raster.west, raster.pixelM, 0, raster.north, 0, -raster.pixelM};
    dataset->SetGeoTransform(transform);
    OGRSpatialReference system;
    if (raster.epsg != 0) {
        system.importFromEPSG(raster.epsg);
        dataset->SetSpatialRef(&system);
    }
    fill(*dataset->GetRasterBand(1), raster);
    return path;
}

Result<FilePiece> read(const Raster& raster, const ReadSettings& settings = {}) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    return readTerrain(written(folder, raster), settings, progress, {});
}

// Easting and northing of a local point in the raster's system, by PROJ alone.
class ToUtm {
public:
    ToUtm() {
        OGRSpatialReference wgs84, utm;
        wgs84.SetWellKnownGeogCS("WGS84");
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        utm.importFromEPSG(32618);
        transformation_.reset(OGRCreateCoordinateTransformation(&wgs84, &utm));
    }
    glm::dvec2 operator()(const Frame& frame, glm::dvec2 local) const {
        const LonLat place = frame.lonLatFromLocal(local);
        glm::dvec2 point(place.lonDeg, place.latDeg);
        transformation_->Transform(1, &point.x, &point.y);
        return point;
    }

private:
    std::unique_ptr<OGRCoordinateTransformation> transformation_;
};

// Largest difference in metres between the terrain and the raster's plane, over cells well inside.
double worstError(const FilePiece& piece, const Frame& frame, const Raster& raster,
                  double metresPerValue = 1) {
    const ToUtm toUtm;
    const PostGrid& grid = piece.terrain->grid;
    double worst = 0;
    for (int row = 4; row < grid.rows - 4; ++row)
        for (int column = 4; column < grid.columns - 4; ++column) {
            const glm::dvec2 at = toUtm(frame, grid.centre(column, row));
            const double expected = raster.value(at.x, at.y) * metresPerValue - frame.originElevationM() -
                                    earthDropM(grid.centre(column, row));
            worst = std::max(worst,
                             std::abs(expected - double(piece.terrain->elevationM[grid.index(column, row)])));
        }
    return worst;
}

TEST(ReadTerrain, AKnownSlopeComesBackWithinADecimetreOfItsPlace) {
    const Raster raster;  // steep, 1.1 : 1, so that an error of position shows as an error of height
    const auto piece = read(raster);
    ASSERT_TRUE(piece) << piece.error().text();
    ASSERT_TRUE(piece->frame && piece->terrain);
    EXPECT_NEAR(piece->terrain->grid.cellM, 10, 0.01);
    EXPECT_EQ(piece->terrain->grid.columns, 60);
    EXPECT_EQ(piece->terrain->grid.rows, 60);
    EXPECT_EQ(piece->terrain->source.method, TerrainMethod::kept);
    EXPECT_LE(piece->terrain->source.misplacedM, 0.001);
    EXPECT_LT(worstError(*piece, *piece->frame, raster), 0.1);
    const auto lowest =
        std::min_element(piece->terrain->elevationM.begin(), piece->terrain->elevationM.end());
    EXPECT_NEAR(*lowest, 0, 0.02);  // in a corner, far below the middle of the plane
    EXPECT_TRUE(piece->warnings.empty()) << piece->warnings[0].what;
}

TEST(ReadTerrain, JoinsAProject) {
    const Raster raster;
    ReadSettings settings;
    settings.frame = Frame({-73.95, 40.75}, 12.5);
    const auto piece = read(raster, settings);
    ASSERT_TRUE(piece);
    EXPECT_FALSE(piece->frame);
    EXPECT_LT(worstError(*piece, *settings.frame, raster), 0.1);
}

TEST(ReadTerrain, LargePixelsKeepTheirPlace) {
    Raster raster;
    raster.pixelM = 500;  // 30 km
    const auto piece = read(raster);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_TRUE(warns(*piece, "impossible"));  // the slope extends below and above all possible elevations
    raster.value = [](double e, double n) { return 2000 + 0.02 * ((e - 600000) + 0.5 * (n - 4497000)); };
    const auto gentle = read(raster);
    ASSERT_TRUE(gentle);
    EXPECT_LT(worstError(*gentle, *gentle->frame, raster), 0.1);
}

TEST(ReadTerrain, NoDataIsFilledFromAroundAndCounted) {
    Raster raster;
    raster.noData = -9999;
    raster.value = [](double e, double n) { return std::hypot(e - 585300, n - 4511700) < 60 ? -9999 : 25; };
    const auto stated = read(raster);
    ASSERT_TRUE(stated);
    EXPECT_TRUE(warns(*stated, "filled from the cells around"));
    raster.noData = NAN;
    const auto customary = read(raster);
    ASSERT_TRUE(customary);
    EXPECT_TRUE(warns(*customary, "-9999"));
    for (const auto* piece : {&*stated, &*customary})
        for (const float z : piece->terrain->elevationM) EXPECT_NEAR(z, 0, 0.02);
}

TEST(ReadTerrain, UnitScaleAndOffset) {
    Raster raster;
    raster.unit = "ft";
    EXPECT_LT(worstError(read(raster).value(), read(raster)->frame.value(), raster, 0.3048), 0.1);
    raster.unit = "US survey foot";
    EXPECT_LT(worstError(read(raster).value(), read(raster)->frame.value(), raster, 1200.0 / 3937), 0.1);
    raster.unit = "m";
    raster.scale = 0.1;
    raster.offset = -40;
    ReadSettings settings;
    settings.frame = Frame({-73.98, 40.75});
    const auto scaled = read(raster, settings);
    ASSERT_TRUE(scaled);
    Raster expected = raster;
    expected.value = [&](double e, double n) { return raster.value(e, n) * 0.1 - 40; };
    EXPECT_LT(worstError(*scaled, *settings.frame, expected), 0.1);
}

TEST(ReadTerrain, FeetOfTheMapAreAssumedAndReported) {
    Raster raster;
    raster.epsg = 2263;  // New York, US survey feet
    raster.west = 985000;
    raster.north = 215000;
    raster.value = [](double, double) { return 100; };
    ReadSettings settings;
    settings.frame = Frame({-73.98, 40.75});
    const auto piece = read(raster, settings);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_NEAR(piece->terrain->grid.cellM, 3.048, 0.01);
    const double drop = earthDropM(piece->terrain->grid.centre(0, 0));
    EXPECT_NEAR(piece->terrain->elevationM[0], 30.48 - drop, 0.01);
    EXPECT_TRUE(warns(*piece, "no unit"));
    settings.heightUnit = LengthUnit::metres;
    EXPECT_NEAR(read(raster, settings)->terrain->elevationM[0], 100 - drop, 0.01);
}

TEST(ReadTerrain, FirstOfSeveralBands) {
    Raster raster;
    raster.bands = 2;
    const auto piece = read(raster);
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_LT(worstError(*piece, *piece->frame, raster), 0.1);
    EXPECT_TRUE(warns(*piece, "several bands"));
    EXPECT_TRUE(piece->crs.ends_with(", as the file states")) << piece->crs;
}

TEST(ReadTerrain, FarAwayIsCut) {
    Raster raster;
    raster.pixelM = 1000;
    raster.value = [](double, double) { return 7; };
    ReadSettings settings;
    settings.farAwayM = 5000;
    const auto piece = read(raster, settings);
    ASSERT_TRUE(piece);
    const Box2 box = bounds(piece->terrain->grid);
    EXPECT_NEAR(box.high.x - box.low.x, 10000, 1600);
    EXPECT_TRUE(piece->terrain->source.cut);
    EXPECT_TRUE(warns(*piece, "far from the city"));
    settings.frame = Frame({10, 50});
    EXPECT_FALSE(read(raster, settings));
}

TEST(ReadTerrain, AFlatSeaSinksWithTheEarth) {
    Raster raster;
    raster.pixelM = 1000;
    raster.value = [](double, double) { return 7; };
    const auto piece = read(raster);
    ASSERT_TRUE(piece);
    const PostGrid& grid = piece->terrain->grid;
    for (const int column : {0, 10, 30, 55}) {
        const glm::dvec2 at = grid.centre(column, 20);
        const double sunk = (at.x * at.x + at.y * at.y) * 0.87 / 2 / 6'371'009;
        EXPECT_NEAR(piece->terrain->elevationM[grid.index(column, 20)], -sunk, 0.01);
    }
}

TEST(ReadTerrain, WhatCannotBeTerrainIsAnError) {
    Raster raster;
    raster.epsg = 0;
    const auto noCrs = read(raster);
    ASSERT_FALSE(noCrs);
    EXPECT_NE(noCrs.error().what.find("no coordinate reference system"), std::string::npos);
    ReadSettings stated;
    stated.crs = "EPSG:32618";
    EXPECT_TRUE(read(raster, stated));
    stated.crs = "EPSG:28992";  // the Netherlands
    EXPECT_FALSE(read(raster, stated));
    raster.epsg = 32618;
    raster.type = GDT_Byte;
    raster.bands = 3;
    EXPECT_NE(read(raster).error().what.find("picture"), std::string::npos);
    Raster empty;
    empty.noData = -9999;
    empty.value = [](double, double) { return -9999; };
    EXPECT_NE(read(empty).error().what.find("no elevation"), std::string::npos);
}

TEST(ReadTerrain, TruncatedAnywhereNeverCrashes) {
    const tests::TemporaryFolder folder;
    const auto whole = written(folder, Raster{.size = 12});
    std::string content(std::filesystem::file_size(whole), '\0');
    std::ifstream(whole, std::ios::binary).read(content.data(), std::streamsize(content.size()));
    NoProgress progress;
    for (std::size_t length = 0; length < content.size(); length += 13) {
        const auto piece = readTerrain(folder.file("cut.tif", content.substr(0, length)), {}, progress, {});
        EXPECT_TRUE(piece || !piece.error().text().empty());
    }
}

TEST(ReadTerrain, Stops) {
    std::stop_source source;
    source.request_stop();
    const tests::TemporaryFolder folder;
    NoProgress progress;
    const auto piece = readTerrain(written(folder, {}), {}, progress, source.get_token());
    ASSERT_FALSE(piece);
    EXPECT_TRUE(isCancelled(piece.error()));
}

}  // namespace
}  // namespace noonmark
