#include "core/io/read_city.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/gdal_calls.h"
#include "core/city/map_context.h"
#include "core/city/terrain/building_ground.h"
#include "core/io/write_city.h"
#include "tests/core/io/city_reading.h"
#include "tests/core/io/cityjson_fixtures.h"
#include "tests/core/io/osm_text.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/box_obj.h"
#include "tests/shared/growing_progress.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::sizedRectangle;

class ReadCity : public tests::CityReading {
protected:
    std::string errorOf(const std::vector<std::filesystem::path>& files) {
        NoProgress quiet;
        const auto result = readCity(files, settings, quiet, {});
        EXPECT_FALSE(result);
        return result ? "" : result.error().text();
    }
    std::filesystem::path osmFile(const std::string& name, float west) {
        tests::OsmText osm;
        osm.way(sizedRectangle(west, 0, 20, 20), {{"building", "yes"}, {"height", "30"}});
        return folder.file(name, osm.xml());
    }
    // Ground at 5 m in the west and 25 m in the east of 40.75 N 73.98 W.
    std::filesystem::path terrainFile() {
        const GdalCalls calls;
        auto path = folder.path("ground.tif");
        const GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
            path.c_str(), 100, 100, 1, GDT_Float32, nullptr));
        double placing[] = {-73.99, 0.0002, 0, 40.76, 0, -0.0002};
        dataset->SetGeoTransform(placing);
        OGRSpatialReference wgs84;
        wgs84.SetWellKnownGeogCS("WGS84");
        dataset->SetSpatialRef(&wgs84);
        std::vector<float> heights(10000, 5.0F);
        for (std::size_t i = 0; i < heights.size(); ++i) heights[i] = i % 100 < 50 ? 5.0F : 25.0F;
        EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 100, 100, heights.data(), 100, 100,
                                                      GDT_Float32, 0, 0),
                  CE_None);
        return path;
    }

    tests::TemporaryFolder folder;
};

TEST_F(ReadCity, OneFileIsACity) {
    const CityRead read = this->read({osmFile("a.osm", 0)});
    EXPECT_EQ(read.city.buildings.size(), 1U);
    EXPECT_EQ(read.city.terrain, nullptr);
    EXPECT_EQ(read.format, "OpenStreetMap XML");
    EXPECT_THAT(read.attribution, HasSubstr("OpenStreetMap contributors"));
    EXPECT_EQ(read.features, 1U);
}

TEST_F(ReadCity, TheFirstFileFixesTheFrameForAll) {
    const auto first = osmFile("a.osm", 0);
    const CityRead both = read({first, osmFile("b.osm", 1000)});
    ASSERT_EQ(both.city.buildings.size(), 2U);
    EXPECT_EQ(both.city.frame, read({first}).city.frame);
    EXPECT_NEAR(bounds(*both.city.buildings[1]).low.x - bounds(*both.city.buildings[0]).low.x, 1000, 0.05);
    EXPECT_EQ(both.format, "OpenStreetMap XML");
    EXPECT_EQ(both.features, 2U);
}

TEST_F(ReadCity, BuildingsStandOnTheTerrainWhereverItIsNamed) {
    const auto west = osmFile("a.osm", -300);
    const auto east = osmFile("b.osm", 300);
    const auto ground = terrainFile();
    for (const auto& files : {std::vector{west, east, ground}, std::vector{ground, west, east}}) {
        const CityRead read = this->read(files);
        ASSERT_NE(read.city.terrain, nullptr);
        ASSERT_EQ(read.city.buildings.size(), 2U);
        const float low = read.city.buildings[0]->parts[0].bottomM;
        EXPECT_NEAR(read.city.frame.originElevationM() + double(low), 5, 0.01);
        EXPECT_NEAR(read.city.buildings[0]->parts[0].topM - low, 30, 0.01);
        // 600 m away, the earth's curvature has lowered the ground by 2.5 cm.
        EXPECT_NEAR(read.city.buildings[1]->parts[0].bottomM - low, 20 - 0.025, 0.01);
    }
}

TEST_F(ReadCity, GroundElevationsWithoutTerrainAreTakenOffAndReported) {
    const auto file = folder.file(
        "a.geojson",
        R"({"type":"FeatureCollection","features":[)"
        R"({"type":"Feature","properties":{"height":9,"ground_elevation":10},"geometry":{"type":"Polygon","coordinates":[[[0,0],[0.0002,0],[0.0002,0.0002],[0,0]]]}},)"
        R"({"type":"Feature","properties":{"height":9,"ground_elevation":50},"geometry":{"type":"Polygon","coordinates":[[[0.001,0],[0.0012,0],[0.0012,0.0002],[0.001,0]]]}}]})");
    const CityRead read = this->read({file});
    for (const auto& building : read.city.buildings) {
        EXPECT_FLOAT_EQ(building->parts[0].bottomM, 0);
        EXPECT_FLOAT_EQ(building->parts[0].topM, 9);
    }
    ASSERT_EQ(read.warnings.size(), 1U);
    EXPECT_THAT(read.warnings[0].what, HasSubstr("there is no terrain"));
}

TEST_F(ReadCity, OurOwnGeoPackageGivesTheSameCityBack) {
    tests::OsmText osm;
    osm.way(sizedRectangle(0, 0, 60, 60), {{"building", "yes"}, {"height", "40"}, {"name", "Hall"}});
    osm.way(sizedRectangle(0, 0, 60, 30), {{"building:part", "yes"}, {"height", "10"}});
    osm.way(sizedRectangle(10, 5, 20, 20),
            {{"building:part", "yes"}, {"height", "40"}, {"min_height", "10"}});
    osm.way(sizedRectangle(0, 30, 60, 30), {{"building:part", "yes"}, {"height", "22"}, {"min_height", "6"}});
    osm.relation(sizedRectangle(100, 0, 40, 40), {sizedRectangle(110, 10, 20, 20)},
                 {{"building", "construction"}});
    osm.way(sizedRectangle(200, 0, 10, 10), {{"building", "roof"}, {"building:levels", "2"}});
    const City city = read({folder.file("a.osm", osm.xml())}).city;
    ASSERT_TRUE(writeCityGeoPackage(folder.path("a.gpkg"), city));
    settings.frame = city.frame;
    const CityRead back = read({folder.path("a.gpkg")});
    EXPECT_EQ(back.format, "GeoPackage");
    EXPECT_TRUE(back.warnings.empty()) << lineOf(groupWarnings(back.warnings)[0]);
    ASSERT_EQ(back.city.buildings.size(), city.buildings.size());
    for (std::size_t i = 0; i < city.buildings.size(); ++i) {
        const Building& before = *city.buildings[i];
        const Building& after = *back.city.buildings[i];
        EXPECT_EQ(after.sourceId, before.sourceId);
        EXPECT_EQ(after.name, before.name);
        EXPECT_EQ(after.status, before.status);
        ASSERT_EQ(after.parts.size(), before.parts.size());
        for (std::size_t p = 0; p < before.parts.size(); ++p) {
            EXPECT_EQ(after.parts[p].sourceId, before.parts[p].sourceId);
            EXPECT_NEAR(after.parts[p].bottomM, before.parts[p].bottomM, 1e-4);
            EXPECT_NEAR(after.parts[p].topM, before.parts[p].topM, 1e-4);
            EXPECT_EQ(after.parts[p].heightSource, before.parts[p].heightSource);
            EXPECT_EQ(after.parts[p].isOverhanging, before.parts[p].isOverhanging);
            EXPECT_NEAR(area(after.parts[p].footprint), area(before.parts[p].footprint), 0.05);
            EXPECT_EQ(after.parts[p].footprint.holes.size(), before.parts[p].footprint.holes.size());
        }
    }
}

TEST_F(ReadCity, MidtownSurvivesItsGeoPackage) {
    const auto file = tests::sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!file) GTEST_SKIP() << "the shared Midtown extract is missing";
    const City city = read({*file}).city;
    ASSERT_TRUE(writeCityGeoPackage(folder.path("m.gpkg"), city));
    settings.frame = city.frame;
    const City back = read({folder.path("m.gpkg")}).city;
    ASSERT_EQ(back.buildings.size(), city.buildings.size());
    for (std::size_t i = 0; i < city.buildings.size(); ++i) {
        ASSERT_EQ(back.buildings[i]->parts.size(), city.buildings[i]->parts.size())
            << city.buildings[i]->sourceId;
        EXPECT_NEAR(topM(*back.buildings[i]), topM(*city.buildings[i]), 1e-3) << city.buildings[i]->sourceId;
        for (std::size_t p = 0; p < city.buildings[i]->parts.size(); ++p)
            EXPECT_EQ(back.buildings[i]->parts[p].isOverhanging, city.buildings[i]->parts[p].isOverhanging);
    }
}

TEST_F(ReadCity, WarningsSayWhoseTheyAreAmongSeveralFiles) {
    tests::OsmText osm;
    osm.way(sizedRectangle(0, 0, 20, 20), {{"building", "yes"}});
    const CityRead read = this->read({osmFile("a.osm", 50), folder.file("b.osm", osm.xml())});
    ASSERT_EQ(read.warnings.size(), 1U);
    EXPECT_EQ(read.warnings[0].where, "b.osm: way 1");
}

TEST_F(ReadCity, AMapSaysWhereWaterIs) {
    tests::OsmText osm;
    osm.way(sizedRectangle(0, 0, 20, 20), {{"building", "yes"}, {"height", "30"}});
    osm.relation(sizedRectangle(100, 0, 80, 50), {sizedRectangle(120, 10, 20, 20)}, {{"natural", "water"}});
    osm.way(sizedRectangle(200, 0, 30, 30), {{"leisure", "park"}});
    const CityRead read = this->read({folder.file("river.osm", osm.xml()), osmFile("dry.osm", 300)});
    ASSERT_NE(read.city.context, nullptr);
    ASSERT_EQ(read.city.context->areas.size(), 1U) << "and nothing else";
    EXPECT_EQ(read.city.context->areas[0].kind, ContextKind::water);
    EXPECT_NEAR(area(read.city.context->areas[0].polygons.at(0)), 80 * 50 - 20 * 20, 1)
        << "without the island";
    EXPECT_EQ(this->read({osmFile("dry.osm", 300)}).city.context, nullptr);
}

TEST_F(ReadCity, AFileThatCannotBeReadNamesItself) {
    EXPECT_THAT(errorOf({osmFile("a.osm", 0), folder.file("b.geojson", "{}")}), HasSubstr("b.geojson"));
    EXPECT_THAT(errorOf({folder.path("missing.osm")}), HasSubstr("missing.osm"));
    EXPECT_FALSE(errorOf({}).empty());
}

TEST_F(ReadCity, ProgressOfSeveralFilesOnlyGrows) {
    tests::GrowingProgress progress;
    ASSERT_TRUE(readCity({osmFile("a.osm", 0), osmFile("b.osm", 100)}, settings, progress, {}));
    EXPECT_TRUE(progress.grew);
    EXPECT_DOUBLE_EQ(progress.last, 1);
}

TEST_F(ReadCity, CanBeStopped) {
    std::stop_source stop;
    stop.request_stop();
    NoProgress quiet;
    const auto result = readCity({osmFile("a.osm", 0)}, settings, quiet, stop.get_token());
    ASSERT_FALSE(result);
    EXPECT_TRUE(isCancelled(result.error()));
}

// The same limits apply to meshes of every file format.
TEST_F(ReadCity, LeavesOutShapesThatNoBuildingCanHave) {
    tests::CityJsonMaker maker;
    maker.addBuilding("tower", maker.boxSolid({0, 0, 0}, {30, 30, 1990}));
    maker.addBuilding("needle", maker.boxSolid({50, 0, 0}, {60, 10, 2010}));
    maker.addBuilding("orbit", maker.boxSolid({50, 50, 1e9}, {60, 60, 1e9 + 10}));
    const CityRead city = read({folder.file("a.city.json", maker.document().dump())});
    ASSERT_EQ(city.city.buildings.size(), 1U);
    EXPECT_EQ(city.city.buildings[0]->sourceId, "tower");
    std::vector<std::string> left;
    for (const Warning& warning : city.warnings)
        if (warning.kind == WarningKind::leftOut) left.push_back(warning.where + ": " + warning.what);
    EXPECT_THAT(left, ElementsAre("a.city.json: needle: it is higher than 2,000 m",
                                  "a.city.json: orbit: it lies more than 20 km below or above the ground"));
}

TEST_F(ReadCity, AMeshInMillimetresIsRefusedWithWhatToDo) {
    settings.meshAnchor = LonLat{-73.98, 40.75};
    EXPECT_THAT(errorOf({folder.file("mm.obj", tests::boxObj(10000, 12000, 30000))}),
                HasSubstr("it is higher than 2,000 m"));
}

}  // namespace
}  // namespace noonmark
