#include "core/io/footprints/read_parcels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "core/base/gdal_calls.h"

#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

const Frame cityFrame({-73.98, 40.75});

std::string squareAt(double west, const std::string& properties) {
    return fmt::format(
        R"({{"type":"Feature","properties":{{{}}},"geometry":{{"type":"Polygon","coordinates":)"
        R"([[[{:.4f},40.75],[{:.4f},40.75],[{:.4f},40.751],[{:.4f},40.751],[{:.4f},40.75]]]}}}})",
        properties, west, west + 0.001, west + 0.001, west, west);
}

std::string collection(const std::vector<std::string>& features) {
    return fmt::format(R"({{"type":"FeatureCollection","features":[{}]}})", fmt::join(features, ","));
}

class ReadParcels : public testing::Test {
protected:
    Result<std::vector<Parcel>> read(const ParcelSettings& settings) {
        return readParcels(file_, settings, cityFrame, stop_.get_token());
    }

    tests::TemporaryFolder folder_;
    std::stop_source stop_;
    std::filesystem::path file_ = folder_.file(
        "plots.geojson",
        collection({squareAt(-73.98, R"("lot":7,"owner":"a")"), squareAt(-73.979, R"("lot":8,"owner":"b")"),
                    squareAt(13.4, R"("lot":9,"owner":"c")")}));
};

TEST_F(ReadParcels, NamesComeFromAUsualFieldOrTheOneAsked) {
    const Region here = makeRegionFromLocalBox({{-1000, -1000}, {1000, 1000}});
    const auto standard = read({.within = here}).value();
    ASSERT_EQ(standard.size(), 2U);  // the third is in another city
    EXPECT_EQ(standard[0].name, "7");
    EXPECT_NEAR(area(standard[0].polygons[0]), 84.45 * 111.04, 20);
    EXPECT_EQ(read({.nameField = "OWNER", .within = here}).value()[1].name, "b");
}

TEST_F(ReadParcels, ThoseAskedForAlone) {
    EXPECT_EQ(read({.names = {"8"}}).value().size(), 1U);
    const auto east = read({.within = makeRegionFromLocalBox({{90, 0}, {200, 200}})}).value();
    ASSERT_EQ(east.size(), 1U);
    EXPECT_EQ(east[0].name, "8");
}

TEST_F(ReadParcels, WhatIsWrongIsReported) {
    EXPECT_THAT(read({}).error().text(), HasSubstr("km from the city"));
    EXPECT_THAT(read({.nameField = "street"}).error().text(), HasSubstr("lot, owner"));
    EXPECT_THAT(read({.layer = "roads"}).error().text(), HasSubstr("plots"));
    EXPECT_THAT(read({.names = {"77"}}).error().text(), HasSubstr("7, 8, 9"));
    file_ = folder_.file("empty.geojson", "{}");
    EXPECT_FALSE(read({}));
    file_ = folder_.path("gone.gpkg");
    EXPECT_THAT(read({}).error().text(), HasSubstr("gone.gpkg"));
}

TEST_F(ReadParcels, ARegisterOfAWholeCityIsRefusedAndStops) {
    std::vector<std::string> many;
    for (std::size_t i = 0; i <= ParcelSettings::maxParcels; ++i)
        many.push_back(squareAt(-73.98, fmt::format(R"("lot":{})", i)));
    file_ = folder_.file("many.geojson", collection(many));
    EXPECT_THAT(read({}).error().text(), HasSubstr("more than 5000 parcels"));
    EXPECT_EQ(read({.names = {"12"}}).value().size(), 1U);
    stop_.request_stop();
    EXPECT_TRUE(isCancelled(read({}).error()));
}

// In the system of New York's register: NAD83, Long Island, US survey feet.
void writeFeetShapefile(const std::filesystem::path& file, double eastFt, double northFt, double sideFt) {
    const GdalCalls calls;
    const GDALDatasetUniquePtr made(GetGDALDriverManager()
                                        ->GetDriverByName("ESRI Shapefile")
                                        ->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    OGRSpatialReference feet;
    feet.importFromEPSG(2263);
    OGRLayer* layer = made->CreateLayer("plots", &feet, wkbPolygon, nullptr);
    OGRFieldDefn name("BBL", OFTString);
    layer->CreateField(&name);
    OGRLinearRing ring;
    for (const auto& [x, y] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}})
        ring.addPoint(eastFt + x * sideFt, northFt + y * sideFt);
    OGRPolygon square;
    square.addRing(&ring);
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(layer->GetLayerDefn()));
    feature->SetField(0, "1010290027");
    feature->SetGeometry(&square);
    ASSERT_EQ(layer->CreateFeature(feature.get()), OGRERR_NONE);
}

TEST_F(ReadParcels, AShapefileInFeetIsInMetres) {
    file_ = folder_.path("plots.shp");
    writeFeetShapefile(file_, 990'000, 217'000, 200);
    const auto plots = read({}).value();
    ASSERT_EQ(plots.size(), 1U);
    EXPECT_EQ(plots[0].name, "1010290027");
    EXPECT_NEAR(area(plots[0].polygons[0]), 200 * 200 * 0.3048 * 0.3048, 0.5)
        << "scale of the projection: 1e-4";
    // The corner as computed by gdaltransform.
    const Box2 box = bounds(plots[0].polygons[0]);
    const LonLat corner = cityFrame.lonLatFromLocal(glm::dvec2(box.low));
    EXPECT_NEAR(corner.lonDeg, -73.9792435, 1e-6);
    EXPECT_NEAR(corner.latDeg, 40.7622894, 1e-6);
}

}  // namespace
}  // namespace noonmark
