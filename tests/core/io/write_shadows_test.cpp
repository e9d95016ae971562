#include "core/io/shadows/write_shadows.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "core/base/gdal_calls.h"
#include "core/io/shadows/shadow_drawing.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using namespace std::chrono;

const Frame midtown({-73.98, 40.75});

Footprint withHole(float west, float south, float side, float hole) {
    const Ring inner = rectangle(west + 5, south + 5, west + 5 + hole, south + 5 + hole);
    return {rectangle(west, south, west + side, south + side), {Ring(inner.rbegin(), inner.rend())}};
}

DrawnTime timeNamed(std::string name) {
    const Instant at = sys_days{year{2026} / 3 / 21} + 13h;
    SunStep sun{towardsSun(120, 30), 120, 30, 0, at};
    return {std::move(name), "2026-03-21", "2026-03-21 09:00 America/New_York", sun};
}

// Baseline: 100 x 100 m with a hole of 40 x 40 m and a box of 20 x 30 m; incremental: 60 x 60 m with a hole
// of 10 x 10 m; gained: none.
ShadowDrawing smallDrawing() {
    ShadowDrawing drawing;
    drawing.frame = midtown;
    drawing.area = {{-200, -200}, {300, 300}};
    ShadowOutlines outlines;
    outlines.baseline = {withHole(0, 0, 100, 40), {rectangle(150, 0, 170, 30), {}}};
    outlines.incremental = {withHole(-150, -100, 60, 10)};
    drawing.moments.push_back({timeNamed("2026-03-21_0900"), outlines});
    drawing.buildings.push_back(
        {"way 1", "Tower <A> \"&\"", BuildingState::proposed, {rectangle(0, -50, 20, -20), {}}, 0, 120});
    drawing.buildings.push_back(
        {"way 2", "", BuildingState::unchanged, {rectangle(40, -50, 60, -20), {}}, 3, 30});
    drawing.places.push_back(
        {"Sheep 公園 \"Ü\" \\P", PlaceKind::park, {{rectangle(-50, 100, 50, 200), {}}}, ""});
    drawing.fans.push_back({"2026-03-21",
                            {{timeNamed("2026-03-21_0900"), {{rectangle(0, 0, 10, 10), {}}}}},
                            {{rectangle(0, 0, 10, 10), {}}}});
    drawing.isochrones.push_back(
        {"2026-03-21", 2, {{120, {{0, 0}, {30, 0}, {30, 40}}, true}, {60, {{0, 0}, {50, 0}}, false}}});
    drawing.distances.push_back({5, {{rectangle(-5, -55, 25, -15), {}}}});
    drawing.notes = {"From Existing to Tower; 東京"};
    return drawing;
}

constexpr double baselineM2 = 100 * 100 - 40 * 40 + 20 * 30, incrementalM2 = 60 * 60 - 10 * 10;

GDALDatasetUniquePtr openedDrawing(const std::filesystem::path& file, const char* driver) {
    const GdalCalls calls;
    const char* const drivers[]{driver, nullptr};
    return GDALDatasetUniquePtr(
        GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
}

std::map<std::string, double> hatchedAreasByLayer(GDALDataset& dxf) {
    std::map<std::string, double> areas;
    for (const auto& feature : *dxf.GetLayer(0)) {
        const OGRGeometry* shape = feature->GetGeometryRef();
        if (shape != nullptr && OGR_GT_IsSubClassOf(wkbFlatten(shape->getGeometryType()), wkbPolygon))
            areas[feature->GetFieldAsString("Layer")] += shape->toPolygon()->get_Area();
        if (shape != nullptr && wkbFlatten(shape->getGeometryType()) == wkbMultiPolygon)
            areas[feature->GetFieldAsString("Layer")] += shape->toMultiPolygon()->get_Area();
    }
    return areas;
}

TEST(WriteShadows, DxfHasTheOutlinesAreasOnALayerForEachTimeAndKind) {
    const TemporaryFolder folder;
    const auto file = folder.path("shadows.dxf");
    const auto written = writeShadowsDxf(file, smallDrawing(), DrawingPlane::local);
    ASSERT_TRUE(written) << written.error().text();
    const auto dxf = openedDrawing(file, "DXF");
    ASSERT_TRUE(dxf);
    const auto areas = hatchedAreasByLayer(*dxf);
    EXPECT_EQ(areas.size(), 2U);
    EXPECT_NEAR(areas.at("2026-03-21_0900_baseline"), baselineM2, 0.01);
    EXPECT_NEAR(areas.at("2026-03-21_0900_incremental"), incrementalM2, 0.01);
}

TEST(WriteShadows, DxfHasClosedLinesTextsAndMetres) {
    const TemporaryFolder folder;
    const auto file = folder.path("shadows.dxf");
    ASSERT_TRUE(writeShadowsDxf(file, smallDrawing(), DrawingPlane::local));
    const auto dxf = openedDrawing(file, "DXF");
    ASSERT_TRUE(dxf);
    std::multiset<std::string> lines;
    std::string texts;
    OGREnvelope tower;
    for (const auto& feature : *dxf->GetLayer(0)) {
        const std::string layer = feature->GetFieldAsString("Layer");
        texts += feature->GetFieldAsString("Text");
        if (wkbFlatten(feature->GetGeometryRef()->getGeometryType()) != wkbLineString) continue;
        lines.insert(layer);
        EXPECT_EQ(feature->GetGeometryRef()->toLineString()->get_IsClosed() != 0,
                  layer != "isochrones_2026-03-21_60");
        if (layer == "buildings_proposed") feature->GetGeometryRef()->getEnvelope(&tower);
    }
    EXPECT_EQ(lines.count("2026-03-21_0900_baseline"), 3U);  // a ring, its hole, and another ring
    for (const char* layer :
         {"buildings", "buildings_proposed", "places", "fan_2026-03-21_0900", "fan_2026-03-21",
          "isochrones_2026-03-21_120", "isochrones_2026-03-21_60", "distance_5m", "area"})
        EXPECT_EQ(lines.count(layer), 1U) << layer;
    EXPECT_THAT(texts, testing::HasSubstr("Sheep 公園 \"Ü\" \\P"));
    EXPECT_THAT(texts, testing::HasSubstr("+proj=tmerc +lat_0=40.75 +lon_0=-73.98 +k=1"));
    EXPECT_THAT(texts, testing::HasSubstr("東京"));
    // The local plane has the frame's own metres.
    EXPECT_NEAR(tower.MinX, 0, 1e-3);
    EXPECT_NEAR(tower.MinY, -50, 1e-3);
    EXPECT_NEAR(tower.MaxY, -20, 1e-3);
    EXPECT_THAT(readBytes(file), testing::ContainsRegex("INSUNITS\r?\n *70\r?\n *6"));
}

TEST(WriteShadows, DxfInTheUtmZoneIsWhereTheOriginIs) {
    const TemporaryFolder folder;
    const auto file = folder.path("shadows.dxf");
    ASSERT_TRUE(writeShadowsDxf(file, smallDrawing(), DrawingPlane::utm));
    const auto dxf = openedDrawing(file, "DXF");
    OGREnvelope all;
    ASSERT_EQ(dxf->GetLayer(0)->GetExtent(&all), OGRERR_NONE);
    // Zone 18, of central meridian 75 W: 1.02 deg east of it at 40.75 N are 86,090 m x 0.9996 east of
    // 500,000.
    EXPECT_NEAR((all.MinX + all.MaxX) / 2, 586060, 300);
    EXPECT_NEAR((all.MinY + all.MaxY) / 2, 4511600, 600);
    EXPECT_NEAR(hatchedAreasByLayer(*dxf).at("2026-03-21_0900_baseline") / baselineM2, 0.9996 * 0.9996, 4e-4);
    EXPECT_THAT(describePlane(midtown, DrawingPlane::utm).value(), testing::HasSubstr("EPSG:32618"));
}

TEST(WriteShadows, ThereIsNoUtmZoneAtThePole) {
    const TemporaryFolder folder;
    ShadowDrawing drawing = smallDrawing();
    drawing.frame = Frame({10, 89});
    const auto written = writeShadowsDxf(folder.path("pole.dxf"), drawing, DrawingPlane::utm);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), testing::HasSubstr("UTM"));
    EXPECT_TRUE(writeShadowsDxf(folder.path("pole.dxf"), drawing, DrawingPlane::local));
}

TEST(WriteShadows, GeoPackageHasTheLayersWithTheirFields) {
    const TemporaryFolder folder;
    const auto file = folder.path("shadows.gpkg");
    const auto written = writeShadowsGeoPackage(file, smallDrawing(), DrawingPlane::local);
    ASSERT_TRUE(written) << written.error().text();
    const auto package = openedDrawing(file, "GPKG");
    ASSERT_TRUE(package);
    std::vector<std::string> names;
    for (OGRLayer* layer : package->GetLayers()) names.emplace_back(layer->GetName());
    EXPECT_THAT(names, testing::ElementsAre("shadows", "buildings", "places", "fan", "isochrones",
                                            "distances", "layer_styles"));
    OGRLayer& shadows = *package->GetLayerByName("shadows");
    EXPECT_EQ(shadows.GetFeatureCount(), 2);
    std::map<std::string, double> areas;
    for (const auto& feature : shadows) {
        const std::string kind = feature->GetFieldAsString("kind");
        areas[kind] = feature->GetGeometryRef()->toMultiPolygon()->get_Area();
        EXPECT_NEAR(areas[kind], feature->GetFieldAsDouble("area_m2"), 0.01);
        EXPECT_STREQ(feature->GetFieldAsString("time"), "2026-03-21 09:00 America/New_York");
        EXPECT_STREQ(feature->GetFieldAsString("utc"), "2026/03/21 13:00:00+00");
        EXPECT_EQ(feature->GetFieldAsDouble("azimuth_deg"), 120);
        EXPECT_EQ(feature->GetFieldAsDouble("altitude_deg"), 30);
        EXPECT_TRUE(feature->GetGeometryRef()->IsValid());
    }
    EXPECT_NEAR(areas.at("baseline"), baselineM2, 0.01);
    EXPECT_NEAR(areas.at("incremental"), incrementalM2, 0.01);
    const OGRFeatureUniquePtr tower(package->GetLayerByName("buildings")->GetNextFeature());
    EXPECT_STREQ(tower->GetFieldAsString("name"), "Tower <A> \"&\"");
    EXPECT_STREQ(tower->GetFieldAsString("state"), "proposed");
    EXPECT_EQ(tower->GetFieldAsDouble("height_m"), 120);
    const OGRFeatureUniquePtr park(package->GetLayerByName("places")->GetNextFeature());
    EXPECT_STREQ(park->GetFieldAsString("name"), "Sheep 公園 \"Ü\" \\P");
    EXPECT_EQ(park->GetFieldAsDouble("area_m2"), 10000);
}

TEST(WriteShadows, GeoJsonIsInLongitudeAndLatitude) {
    const TemporaryFolder folder;
    const auto file = folder.path("shadows.geojson");
    ASSERT_TRUE(writeShadowsGeoJson(file, smallDrawing(), "shadows"));
    const auto json = openedDrawing(file, "GeoJSON");
    ASSERT_TRUE(json);
    double baseline = 0;
    for (const auto& feature : *json->GetLayer(0)) {
        if (std::string(feature->GetFieldAsString("kind")) != "baseline") continue;
        // Back to local metres: an area on the ground.
        for (const auto* polygon : *feature->GetGeometryRef()->toMultiPolygon())
            for (const auto* ring : *polygon) {
                Ring local;
                for (const OGRPoint& point : *ring)
                    local.emplace_back(midtown.localFromLonLat({point.getX(), point.getY()}));
                local.pop_back();
                baseline += signedArea(local);
            }
    }
    EXPECT_NEAR(baseline, baselineM2, 0.1);
    const auto missing = writeShadowsGeoJson(folder.path("x.geojson"), smallDrawing(), "trees");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().text(), testing::HasSubstr("trees"));
}

TEST(WriteShadows, ADrawingWithoutShadowStillOpens) {
    const TemporaryFolder folder;
    ShadowDrawing drawing;
    drawing.frame = midtown;
    drawing.area = {{0, 0}, {10, 10}};
    ASSERT_TRUE(writeShadowsDxf(folder.path("a.dxf"), drawing, DrawingPlane::local));
    ASSERT_TRUE(writeShadowsGeoPackage(folder.path("a.gpkg"), drawing, DrawingPlane::local));
    EXPECT_TRUE(openedDrawing(folder.path("a.dxf"), "DXF"));
    const auto package = openedDrawing(folder.path("a.gpkg"), "GPKG");
    ASSERT_TRUE(package);
    EXPECT_EQ(package->GetLayerByName("shadows")->GetFeatureCount(), 0);
}

TEST(WriteShadows, AFolderThatDoesNotExistIsAnError) {
    const auto written = writeShadowsDxf("/nowhere/at/all/shadows.dxf", smallDrawing(), DrawingPlane::local);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), testing::HasSubstr("/nowhere/at/all"));
    EXPECT_FALSE(writeShadowsGeoPackage("/nowhere/at/all/s.gpkg", smallDrawing(), DrawingPlane::local));
    EXPECT_FALSE(writeShadowsGeoJson("/nowhere/at/all/s.geojson", smallDrawing(), "shadows"));
}

TEST(WriteShadows, SvgIsInMillimetresOnPaper) {
    const ShadowDrawing drawing = smallDrawing();
    const std::string svg = drawShadowsSvg(drawing, drawing.moments.front(), 2000);
    // 500 m at 1:2000 are 250 mm; the corner (150, 0) of a shadow is 350 m east and 300 m south of the
    // picture's north-western corner.
    EXPECT_THAT(svg, testing::HasSubstr("width=\"250.000mm\""));
    EXPECT_THAT(svg, testing::HasSubstr("M175.0000 150.0000"));
    EXPECT_THAT(svg, testing::HasSubstr("Tower &lt;A&gt; &quot;&amp;&quot; 120.0 m"));
    EXPECT_THAT(svg, testing::HasSubstr("公園"));
    EXPECT_THAT(svg, testing::HasSubstr("1:2000"));
    EXPECT_THAT(svg, testing::Not(testing::HasSubstr("<A>")));
}

TEST(LayerNames, AreTakenByEveryCadProgramAndDiffer) {
    LayerNames names;
    EXPECT_EQ(names.add("2026-03-21_0900_incremental"), "2026-03-21_0900_incremental");
    EXPECT_EQ(names.add("Größe: 1"), "Gr__e__1");
    EXPECT_EQ(names.add("Gr__e__1"), "Gr__e__1_2");
    EXPECT_EQ(names.add("GR__E__1"), "GR__E__1_3");
    EXPECT_EQ(names.add("a<>/\\\":;?*|=`b\n"), "a____________b_");
    EXPECT_EQ(names.add("公園"), "__");
    EXPECT_EQ(names.add(""), "layer");
    EXPECT_EQ(names.add(std::string(300, 'x')).size(), 200U);
}

}  // namespace
}  // namespace noonmark
