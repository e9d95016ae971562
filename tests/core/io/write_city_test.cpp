#include "core/io/write_city.h"
#include "core/base/gdal_calls.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Ring square(float x, float y, float side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

std::shared_ptr<const Building> towerOnPodium() {
    Building building{.sourceId = "way 1", .name = "Grüne Höhe \"2\"", .status = "to be built"};
    building.parts.push_back({.sourceId = "way 2",
                              .footprint = {square(100, 200, 40), {{{110, 210}, {110, 215}, {115, 210}}}},
                              .bottomM = 3,
                              .topM = 15,
                              .heightSource = HeightSource::measured});
    building.parts.push_back(
        {.sourceId = "way 3", .footprint = {square(110, 220, 10), {}}, .bottomM = 15, .topM = 103});
    building.parts.push_back({.sourceId = "way 4",
                              .footprint = {square(140, 220, 5), {}},
                              .bottomM = 8,
                              .topM = 9,
                              .heightSource = HeightSource::levels,
                              .isOverhanging = true});
    return std::make_shared<const Building>(std::move(building));
}

class WriteCity : public testing::Test {
protected:
    WriteCity() { const GdalCalls prepared; }

    void write(const City& city) {
        const auto written = writeCityGeoPackage(folder.path("city.gpkg"), city);
        ASSERT_TRUE(written) << written.error().text();
        warnings = *written;
        dataset.reset(GDALDataset::Open((folder.path("city.gpkg")).c_str(), GDAL_OF_VECTOR));
        ASSERT_TRUE(dataset);
        layer = dataset->GetLayerByName("buildings");
        ASSERT_NE(layer, nullptr);
    }
    OGRFeatureUniquePtr feature(GIntBig id) { return OGRFeatureUniquePtr(layer->GetFeature(id)); }

    tests::TemporaryFolder folder;
    GDALDatasetUniquePtr dataset;
    OGRLayer* layer = nullptr;
    Warnings warnings;
};

TEST_F(WriteCity, EveryPartIsAFeatureWithHeightsAboveTheGround) {
    write({Frame({-73.98, 40.75}, 20), {towerOnPodium()}, nullptr});
    ASSERT_EQ(layer->GetFeatureCount(), 3);
    const auto tower = feature(2);
    EXPECT_STREQ(tower->GetFieldAsString("building_id"), "way 1");
    EXPECT_STREQ(tower->GetFieldAsString("source_id"), "way 3");
    EXPECT_STREQ(tower->GetFieldAsString("name"), "Grüne Höhe \"2\"");
    EXPECT_STREQ(tower->GetFieldAsString("status"), "to be built");
    EXPECT_DOUBLE_EQ(tower->GetFieldAsDouble("height"), 100);
    EXPECT_DOUBLE_EQ(tower->GetFieldAsDouble("min_height"), 12);
    EXPECT_DOUBLE_EQ(tower->GetFieldAsDouble("ground_elevation"), 23);
    EXPECT_STREQ(tower->GetFieldAsString("height_source"), "assumed");
    EXPECT_EQ(tower->GetFieldAsInteger("hangs"), 0);
    EXPECT_EQ(feature(3)->GetFieldAsInteger("hangs"), 1);
    EXPECT_DOUBLE_EQ(feature(1)->GetFieldAsDouble("min_height"), 0);
    EXPECT_TRUE(warnings.empty());
}

TEST_F(WriteCity, ACityThatKnowsNoElevationStatesNone) {
    // A stated 0 would bury the buildings of a flat sample when a terrain is opened with it.
    City city{Frame({-73.98, 40.75}), {towerOnPodium()}, nullptr};
    Building onGround = *city.buildings[0];
    for (Part& part : onGround.parts) part.bottomM -= 3, part.topM -= 3;
    city.buildings[0] = std::make_shared<const Building>(onGround);
    write(city);
    EXPECT_FALSE(feature(1)->IsFieldSetAndNotNull(layer->GetLayerDefn()->GetFieldIndex("ground_elevation")));
    EXPECT_DOUBLE_EQ(feature(2)->GetFieldAsDouble("height"), 100);
}

TEST_F(WriteCity, OutlinesKeepTheirPlaceTo1Millimetre) {
    const City city{Frame({15.6, 78.2}), {towerOnPodium()}, nullptr};
    write(city);
    const auto podium = feature(1);
    const OGRPolygon* polygon = podium->GetGeometryRef()->toPolygon();
    ASSERT_EQ(polygon->getNumInteriorRings(), 1);
    const Footprint& footprint = city.buildings[0]->parts[0].footprint;
    const auto expectSame = [&](const OGRLinearRing& line, const Ring& ring) {
        ASSERT_EQ(line.getNumPoints(), int(ring.size()) + 1);
        for (int i = 0; i < line.getNumPoints(); ++i) {
            const glm::dvec2 seen = city.frame.localFromLonLat({line.getX(i), line.getY(i)});
            const glm::dvec2 meant(ring[std::size_t(i) % ring.size()]);
            EXPECT_LT(std::hypot(seen.x - meant.x, seen.y - meant.y), 1e-3);
        }
    };
    expectSame(*polygon->getExteriorRing(), footprint.outer);
    expectSame(*polygon->getInteriorRing(0), footprint.holes[0]);
}

TEST_F(WriteCity, CrsIsWgs84) {
    write({Frame({0, 0}), {towerOnPodium()}, nullptr});
    ASSERT_NE(layer->GetSpatialRef(), nullptr);
    EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "4326");
}

TEST_F(WriteCity, BuildingsOfOneSourceIdStayTwo) {
    write({Frame({0, 0}), {towerOnPodium(), towerOnPodium()}, nullptr});
    EXPECT_STREQ(feature(3)->GetFieldAsString("building_id"), "way 1");
    EXPECT_STREQ(feature(4)->GetFieldAsString("building_id"), "way 1 (2)");
}

TEST_F(WriteCity, AMeshIsWrittenAsAPrismAndReported) {
    Building building{.sourceId = "dome"};
    building.parts.push_back({.sourceId = "dome 1",
                              .footprint = {square(0, 0, 4), {}},
                              .bottomM = 0,
                              .topM = 7,
                              .heightSource = HeightSource::mesh,
                              .mesh = std::make_shared<const TriangleMesh>()});
    write({Frame({0, 0}), {std::make_shared<const Building>(building)}, nullptr});
    EXPECT_STREQ(feature(1)->GetFieldAsString("height_source"), "mesh");
    EXPECT_DOUBLE_EQ(feature(1)->GetFieldAsDouble("height"), 7);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].kind, WarningKind::leftOut);
    EXPECT_EQ(warnings[0].where, "dome 1");
}

TEST_F(WriteCity, TerrainIsLeftOutAndReported) {
    const Terrain flat{{-1000, -1000, 1000, 3, 3}, std::vector<float>(9, 3)};
    write({Frame({0, 0}), {towerOnPodium()}, std::make_shared<const Terrain>(flat)});
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings[0].what, HasSubstr("terrain"));
}

TEST_F(WriteCity, ReplacesAnOldFileAndLeavesNothingElse) {
    write({Frame({0, 0}), {towerOnPodium(), towerOnPodium()}, nullptr});
    dataset.reset();
    write({Frame({0, 0}), {towerOnPodium()}, nullptr});
    EXPECT_EQ(layer->GetFeatureCount(), 3);
    dataset.reset();
    EXPECT_THAT(folder.names(), ElementsAre("city.gpkg"));
}

TEST_F(WriteCity, AnEmptyCityIsAnEmptyLayer) {
    write({Frame({0, 0}), {}, nullptr});
    EXPECT_EQ(layer->GetFeatureCount(), 0);
}

TEST_F(WriteCity, SaysWhereItCannotWrite) {
    const auto written =
        writeCityGeoPackage(folder.path("no/such/city.gpkg"), {Frame({0, 0}), {towerOnPodium()}, nullptr});
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), HasSubstr("no/such/city.gpkg"));
}

}  // namespace
}  // namespace noonmark
