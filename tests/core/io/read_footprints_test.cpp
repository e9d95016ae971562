#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "core/base/gdal_calls.h"
#include "core/io/read_part.h"
#include "tests/core/io/osm_text.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/growing_progress.h"

namespace noonmark {
namespace {

using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr LonLat manhattan{-73.98, 40.75};

class ReadFootprints : public testing::Test {
protected:
    Result<FilePiece> tryRead(const std::filesystem::path& file) {
        NoProgress quiet;
        return readFootprints(file, settings, quiet, {});
    }
    FilePiece read(const std::filesystem::path& file) {
        auto result = tryRead(file);
        EXPECT_TRUE(result) << result.error().text();
        return result ? *std::move(result) : FilePiece();
    }
    FilePiece readGeoJson(const std::string& features, const std::string& head = "") {
        return read(geoJson(features, head));
    }
    std::filesystem::path geoJson(const std::string& features, const std::string& head = "") {
        return folder.file("a.geojson",
                           R"({"type":"FeatureCollection",)" + head + R"("features":[)" + features + "]}");
    }
    std::string errorOf(const std::filesystem::path& file) {
        const auto result = tryRead(file);
        EXPECT_FALSE(result);
        return result ? "" : result.error().text();
    }

    tests::TemporaryFolder folder;
    ReadSettings settings;
};

std::string ringText(const std::vector<LonLat>& places) {
    std::string text;
    for (const LonLat place : places) text += fmt::format("[{:.10f},{:.10f}],", place.lonDeg, place.latDeg);
    text += fmt::format("[{:.10f},{:.10f}]", places[0].lonDeg, places[0].latDeg);
    return "[" + text + "]";
}

// A rectangle in metres around a place, as GeoJSON.
std::string feature(const Ring& ring, const std::string& properties, LonLat around = manhattan) {
    std::vector<LonLat> places;
    for (const glm::vec2 point : ring) places.push_back(Frame(around).lonLatFromLocal(glm::dvec2(point)));
    return fmt::format(
        R"({{"type":"Feature","properties":{{{}}},"geometry":{{"type":"Polygon","coordinates":[{}]}}}})",
        properties, ringText(places));
}

std::vector<std::string> whats(const Warnings& warnings) {
    std::vector<std::string> texts;
    for (const Warning& warning : warnings) texts.push_back(warning.what);
    return texts;
}

// Writes one rectangle in the given system with a GDAL driver.
void writeRectangle(const std::filesystem::path& file, const char* driver, const char* crs,
                    const std::vector<std::pair<std::string, double>>& fields) {
    const GdalCalls calls;
    OGRSpatialReference wgs84, system;
    wgs84.SetWellKnownGeogCS("WGS84");
    system.SetFromUserInput(crs);
    for (OGRSpatialReference* one : {&wgs84, &system})
        one->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> there(
        OGRCreateCoordinateTransformation(&wgs84, &system));
    OGRLinearRing line;
    for (const glm::vec2 point : tests::sizedRectangle(-20, -10, 40, 20)) {
        const LonLat place = Frame(manhattan).lonLatFromLocal(glm::dvec2(point));
        double x = place.lonDeg;
        double y = place.latDeg;
        ASSERT_TRUE(there->Transform(1, &x, &y));
        line.addPoint(x, y);
    }
    line.closeRings();
    OGRPolygon polygon;
    polygon.addRing(&line);
    const GDALDatasetUniquePtr dataset(
        GetGDALDriverManager()->GetDriverByName(driver)->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    OGRLayer* layer = dataset->CreateLayer("houses", &system, wkbPolygon, nullptr);
    for (const auto& [name, value] : fields) {
        OGRFieldDefn field(name.c_str(), OFTReal);
        layer->CreateField(&field);
    }
    OGRFeature made(layer->GetLayerDefn());
    for (int i = 0; i < int(fields.size()); ++i) made.SetField(i, fields[std::size_t(i)].second);
    made.SetGeometry(&polygon);
    ASSERT_EQ(layer->CreateFeature(&made), OGRERR_NONE);
}

TEST_F(ReadFootprints, GeoJsonInDegrees) {
    const FilePiece piece = readGeoJson(
        feature(tests::sizedRectangle(-20, -10, 40, 20), R"("id":"tower","name":"A","height":"30 m")"));
    ASSERT_EQ(piece.buildings.size(), 1U);
    ASSERT_TRUE(piece.frame);
    EXPECT_NEAR(piece.frame->origin().lonDeg, manhattan.lonDeg, 1e-7);
    EXPECT_NEAR(piece.frame->origin().latDeg, manhattan.latDeg, 1e-7);
    const Building& building = *piece.buildings[0];
    EXPECT_EQ(building.sourceId, "tower");
    EXPECT_EQ(building.name, "A");
    EXPECT_NEAR(area(building.parts[0].footprint), 800, 0.01);
    EXPECT_FLOAT_EQ(building.parts[0].topM, 30);
    EXPECT_EQ(piece.format, "GeoJSON");
    EXPECT_EQ(piece.features, 1U);
}

double heightOf(const Building& building) {
    return double(building.parts[0].topM) - double(building.parts[0].bottomM);
}

TEST_F(ReadFootprints, FrenchHeightsAreRead) {
    const FilePiece piece =
        readGeoJson(feature(tests::sizedRectangle(0, 0, 10, 10), R"("HAUTEUR":17.3,"NB_ETAGES":5)") + "," +
                    feature(tests::sizedRectangle(20, 0, 10, 10),
                            R"("HAUTEUR":null,"Z_MIN_SOL":40.0,"Z_MIN_TOIT":52.5,"Z_MAX_TOIT":60.0)") +
                    "," + feature(tests::sizedRectangle(40, 0, 10, 10), R"("HAUTEUR":null,"NB_ETAGES":4)"));
    ASSERT_EQ(piece.buildings.size(), 3U);
    EXPECT_NEAR(heightOf(*piece.buildings[0]), 17.3, 1e-4);
    EXPECT_NEAR(heightOf(*piece.buildings[1]), 12.5, 1e-4);
    EXPECT_NEAR(heightOf(*piece.buildings[2]), 12.8, 1e-4);
    ASSERT_EQ(piece.heights.fields.size(), 3U);
    const HeightField& hauteur = piece.heights.fields[0];
    EXPECT_EQ(hauteur, (HeightField{"a.geojson", "HAUTEUR", "base of the roof", "m", 1}));
    EXPECT_EQ(piece.heights.fields[2].field, "Z_MIN_TOIT - Z_MIN_SOL");
    EXPECT_TRUE(piece.heights.unknown.empty());
}

TEST_F(ReadFootprints, BostonsHeightsAreFeet) {
    const FilePiece piece = readGeoJson(feature(
        tests::sizedRectangle(0, 0, 10, 10), R"("BLDG_HGT_2010":"788.19","GRND_ELEV_2010":"14","FLOOR":60)"));
    EXPECT_NEAR(heightOf(*piece.buildings.at(0)), 788.19 * 0.3048, 1e-3);
}

TEST_F(ReadFootprints, TextWithADecimalCommaIsANumber) {
    const FilePiece piece =
        readGeoJson(feature(tests::sizedRectangle(0, 0, 10, 10), R"("altezza":"12,5")") + "," +
                    feature(tests::sizedRectangle(20, 0, 10, 10), R"("altezza":"7,25 m")") + "," +
                    feature(tests::sizedRectangle(40, 0, 10, 10), R"("altezza":"1,250")"));
    EXPECT_NEAR(heightOf(*piece.buildings.at(0)), 12.5, 1e-4);
    EXPECT_NEAR(heightOf(*piece.buildings.at(1)), 7.25, 1e-4);
    EXPECT_NEAR(heightOf(*piece.buildings.at(2)), 9.6, 1e-4) << "a thousand?";
}

TEST_F(ReadFootprints, FieldsThatCouldBeHeightsAreListed) {
    std::string features;
    for (int i = 0; i < 20; ++i) {
        if (i > 0) features += ',';
        features += feature(
            tests::sizedRectangle(float(20 * i), 0, 10, 10),
            fmt::format(R"("H_BAT":{},"NIV":"{}","FID_1":{},"AREA":{},"ANNEE":{},"USE":"home","CLASS":{})",
                        i == 0 ? -9999.0 : 4.5 + 0.5 * i, 1 + i % 6, i + 1, 100.5 + i, 1950 + i,
                        110 + 10 * (i % 4)));
    }
    const FilePiece piece = readGeoJson(features);
    ASSERT_EQ(piece.heights.unknown.size(), 2U);
    EXPECT_EQ(piece.heights.unknown[0], (UnknownField{"a.geojson", "NIV", 1, 6, true, 20}));
    EXPECT_EQ(piece.heights.unknown[1], (UnknownField{"a.geojson", "H_BAT", 5, 14, false, 19}));
    EXPECT_THAT(whats(piece.warnings), testing::Contains(HasSubstr("NIV (1 to 6 in 20 features)")));

    settings.heightField = "h_bat";
    settings.levelsField = "NIV";
    const FilePiece named = readGeoJson(features);
    EXPECT_NEAR(heightOf(*named.buildings.at(1)), 5, 1e-4);
    EXPECT_NEAR(heightOf(*named.buildings.at(0)), 3.2, 1e-4) << "from its storeys";
    settings.levelsField = "NIVEAU";
    EXPECT_THAT(errorOf(geoJson(features)), HasSubstr("There is no field \"NIVEAU\""));
}

TEST_F(ReadFootprints, ACityOnBothSidesOf180DegreesStaysTogether) {
    const LonLat taveuni{179.9999, -16.85};
    const FilePiece piece =
        readGeoJson(feature(tests::sizedRectangle(-200, 0, 10, 10), R"("height":5)", taveuni) + "," +
                    feature(tests::sizedRectangle(0, 0, 100, 10), R"("height":6)", taveuni) + "," +
                    feature(tests::sizedRectangle(200, 0, 10, 10), R"("height":7)", taveuni));
    ASSERT_EQ(piece.buildings.size(), 3U);
    const double west = bounds(*piece.buildings[0]).low.x;
    EXPECT_NEAR(bounds(*piece.buildings[1]).low.x - west, 200, 0.01);
    EXPECT_NEAR(bounds(*piece.buildings[1]).high.x - west, 300, 0.01);
    EXPECT_NEAR(bounds(*piece.buildings[2]).low.x - west, 400, 0.01);
}

TEST_F(ReadFootprints, EverySystemIsReprojected) {
    for (const char* crs : {"EPSG:2263", "EPSG:3857", "EPSG:32618", "EPSG:4269"}) {
        const auto file = folder.path(std::string("a_") + (crs + 5) + ".gpkg");
        writeRectangle(file, "GPKG", crs, {{"height", 12}});
        const FilePiece piece = read(file);
        ASSERT_EQ(piece.buildings.size(), 1U) << crs;
        // The area must not be measured in Web Mercator, where it would be 1,394 m2, or in feet.
        EXPECT_NEAR(area(piece.buildings[0]->parts[0].footprint), 800, 0.1) << crs;
        EXPECT_NEAR(piece.frame->origin().latDeg, manhattan.latDeg, 2e-5) << crs;
    }
}

TEST_F(ReadFootprints, NewYorksShapefileIsInFeet) {
    const auto file = folder.path("nyc.shp");
    writeRectangle(file, "ESRI Shapefile", "EPSG:2263",
                   {{"HEIGHTROOF", 100}, {"GROUNDELEV", 50}, {"BIN", 1}});
    const FilePiece piece = read(file);
    EXPECT_EQ(piece.format, "Shapefile");
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_NEAR(piece.buildings[0]->parts[0].topM, 30.48, 1e-3);
    EXPECT_NEAR(piece.frame->originElevationM(), 15.24, 1e-3);
    EXPECT_THAT(whats(piece.warnings),
                ElementsAre(HasSubstr("feet are assumed"), HasSubstr("feet are assumed")));
}

TEST_F(ReadFootprints, TheUserNamesFieldAndUnit) {
    const auto file =
        geoJson(feature(tests::sizedRectangle(0, 0, 10, 10), R"("height":5,"eaves":100)") + "," +
                feature(tests::sizedRectangle(20, 0, 10, 10), R"("height":5,"eaves":"20 m")"));
    settings.heightField = "EAVES";
    settings.heightUnit = LengthUnit::feet;
    const FilePiece piece = read(file);
    EXPECT_NEAR(piece.buildings[0]->parts[0].topM, 30.48, 1e-4);
    EXPECT_NEAR(piece.buildings[1]->parts[0].topM, 20, 1e-4);
    settings.heightField = "roof_top";
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("roof_top"), HasSubstr("eaves")));
}

TEST_F(ReadFootprints, MultipolygonsAreOneBuilding) {
    const FilePiece piece = readGeoJson(
        R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"MultiPolygon","coordinates":[)"
        R"([[[0,0],[0.0002,0],[0.0002,0.0002],[0,0.0002],[0,0]]],[[[0.0003,0],[0.0005,0],[0.0005,0.0002],[0.0003,0.0002],[0.0003,0]]]]}})");
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_EQ(piece.buildings[0]->parts.size(), 2U);
}

TEST_F(ReadFootprints, PolygonsOfOneFeatureThatOverlapAreJoinedAndSaid) {
    const FilePiece piece = readGeoJson(
        R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"MultiPolygon","coordinates":[)"
        R"([[[0,0],[0.0002,0],[0.0002,0.0002],[0,0.0002],[0,0]]],[[[0.0001,0],[0.0005,0],[0.0005,0.0002],[0.0001,0.0002],[0.0001,0]]]]}})");
    EXPECT_EQ(piece.buildings.at(0)->parts.size(), 1U);
    EXPECT_THAT(whats(piece.warnings), ElementsAre(HasSubstr("were joined")));
}

TEST_F(ReadFootprints, ElevationsInPolygonsAreNotTakenAndSaid) {
    const FilePiece piece = readGeoJson(
        R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":)"
        R"([[[0,0,50],[0.0002,0,50],[0.0002,0.0002,50],[0,0.0002,50],[0,0,50]]]}})");
    EXPECT_FLOAT_EQ(piece.buildings.at(0)->parts[0].topM, 9);
    EXPECT_FLOAT_EQ(piece.buildings.at(0)->parts[0].bottomM, 0);
    EXPECT_THAT(whats(piece.warnings), ElementsAre(HasSubstr("elevations in its polygons")));
}

TEST_F(ReadFootprints, TagsInGeoJsonMeanWhatTheyMeanInOpenStreetMap) {
    const FilePiece piece = readGeoJson(
        feature(tests::sizedRectangle(0, 0, 40, 20), R"("@id":"way/5","building":"yes","height":"90")") +
        "," +
        feature(tests::sizedRectangle(0, 0, 40, 20), R"("@id":"way/6","building:part":"yes","height":"20")") +
        "," + feature(tests::sizedRectangle(80, 0, 40, 20), R"("@id":"way/7","leisure":"park")"));
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_EQ(piece.buildings[0]->parts.size(), 1U);
    EXPECT_FLOAT_EQ(piece.buildings[0]->parts[0].topM, 20);
    EXPECT_THAT(whats(piece.warnings), ElementsAre(HasSubstr("not tagged as a building")));
}

TEST_F(ReadFootprints, ShipsFarAwayDoNotStretchTheScene) {
    const LonLat sea{-77.0, 38.0};
    std::string features;
    for (int i = 0; i < 9; ++i)
        features += feature(tests::sizedRectangle(float(i) * 20, 0, 10, 10),
                            fmt::format(R"("id":"h{}","height":9)", i)) +
                    ",";
    const FilePiece piece = readGeoJson(
        features + feature(tests::sizedRectangle(0, 0, 100, 20), R"("id":"ship","height":30)", sea));
    EXPECT_EQ(piece.buildings.size(), 9U);
    EXPECT_NEAR(piece.frame->origin().lonDeg, manhattan.lonDeg, 0.002);
    ASSERT_EQ(piece.warnings.size(), 1U);
    EXPECT_EQ(piece.warnings[0].kind, WarningKind::leftOut);
    EXPECT_EQ(piece.warnings[0].where, "ship");
}

TEST_F(ReadFootprints, TheOtherSideOfTheEarthIsFarAway) {
    const LonLat antipode{106.02, -40.75};
    std::string features = feature(tests::sizedRectangle(0, 0, 10, 10), R"("height":9)") + "," +
                           feature(tests::sizedRectangle(20, 0, 10, 10), R"("height":9)") + ",";
    const FilePiece piece =
        readGeoJson(features + feature(tests::sizedRectangle(0, 0, 10, 10), R"("height":9)", antipode));
    EXPECT_EQ(piece.buildings.size(), 2U);
}

TEST_F(ReadFootprints, DataOnBothSidesOfTheDateLineStaysTogether) {
    const LonLat fiji{180, -17};
    std::string features;
    for (int i = -3; i <= 3; ++i)
        features += feature(tests::sizedRectangle(float(i) * 200 + 50, 0, 10, 10), R"("height":9)", fiji) +
                    (i < 3 ? "," : "");
    const FilePiece piece = readGeoJson(features);
    EXPECT_EQ(piece.buildings.size(), 7U);
    EXPECT_NEAR(std::abs(piece.frame->origin().lonDeg), 180, 0.01);
}

TEST_F(ReadFootprints, JoinsTheFrameOfAProject) {
    settings.frame = Frame({-73.97, 40.75}, 10);
    const FilePiece piece =
        readGeoJson(feature(tests::sizedRectangle(0, 0, 10, 10), R"("height":9,"ground_elevation":25)"));
    EXPECT_FALSE(piece.frame);
    EXPECT_LT(bounds(*piece.buildings.at(0)).high.x, -800);
    EXPECT_FLOAT_EQ(piece.buildings[0]->parts[0].bottomM, 15);
    ASSERT_EQ(piece.groundM.size(), 1U);
    EXPECT_FLOAT_EQ(piece.groundM[0].value(), 15);
}

TEST_F(ReadFootprints, FeaturesOfOneBuildingIdAreOneBuilding) {
    const FilePiece piece =
        readGeoJson(feature(tests::sizedRectangle(0, 0, 10, 10),
                            R"("building_id":"b1","source_id":"low","height":9,"hangs":0)") +
                    "," +
                    feature(tests::sizedRectangle(50, 0, 10, 10),
                            R"("building_id":"b2","source_id":"x","height":9,"hangs":0)") +
                    "," +
                    feature(tests::sizedRectangle(0, 0, 5, 5),
                            R"("building_id":"b1","source_id":"high","height":30,"min_height":9,"hangs":1)"));
    ASSERT_EQ(piece.buildings.size(), 2U);
    EXPECT_EQ(piece.buildings[0]->sourceId, "b1");
    ASSERT_EQ(piece.buildings[0]->parts.size(), 2U);
    EXPECT_EQ(piece.buildings[0]->parts[1].sourceId, "high");
    EXPECT_TRUE(piece.buildings[0]->parts[1].isOverhanging);
}

TEST_F(ReadFootprints, APlaceholderIsNoBuildingId) {
    const FilePiece piece =
        readGeoJson(feature(tests::sizedRectangle(0, 0, 10, 10), R"("building_id":0,"height":9)") + "," +
                    feature(tests::sizedRectangle(50, 0, 10, 10), R"("building_id":0,"height":9)"));
    EXPECT_EQ(piece.buildings.size(), 2U);
}

TEST_F(ReadFootprints, ADrawingsLayersAreNotStoreysOfTheEarth) {
    const FilePiece piece = readGeoJson(
        feature(tests::sizedRectangle(0, 0, 10, 10), R"("layer":"-1","location":"underground","height":9)"));
    EXPECT_EQ(piece.buildings.size(), 1U);
}

TEST_F(ReadFootprints, OneBadFeatureIsAWarning) {
    const FilePiece piece = readGeoJson(
        feature(tests::sizedRectangle(0, 0, 10, 10), R"("height":9)") + "," +
        feature(tests::sizedRectangle(20, 0, 10, 10), R"("height":9)") + "," +
        R"({"type":"Feature","properties":{"id":"lost"},"geometry":{"type":"Polygon","coordinates":[[[0,95],[1,95],[1,96],[0,95]]]}},)"
        R"({"type":"Feature","properties":{"id":"none"},"geometry":null},)"
        R"({"type":"Feature","properties":{"id":"line"},"geometry":{"type":"Polygon","coordinates":[[[-73.98,40.75],[-73.98,40.75],[-73.98,40.75]]]}})");
    EXPECT_EQ(piece.buildings.size(), 2U);
    std::vector<std::string> places;
    for (const Warning& warning : piece.warnings)
        if (warning.kind == WarningKind::dropped) places.push_back(warning.where);
    EXPECT_THAT(places, testing::UnorderedElementsAre("lost", "none", "line"));
}

TEST_F(ReadFootprints, ALayerMayBeChosen) {
    const auto file = folder.path("two.gpkg");
    writeRectangle(file, "GPKG", "EPSG:4326", {{"height", 12}});
    settings.layer = "houses";
    EXPECT_EQ(read(file).buildings.size(), 1U);
    settings.layer = "lots";
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("lots"), HasSubstr("houses")));
}

TEST_F(ReadFootprints, WithoutASystemTheUserMustStateIt) {
    const auto file = folder.path("a.shp");
    writeRectangle(file, "ESRI Shapefile", "EPSG:2263", {{"height_m", 12}});
    std::filesystem::remove(folder.path("a.prj"));
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("a.shp"), HasSubstr("--crs")));
    settings.crs = "EPSG:2263";
    const FilePiece piece = read(file);
    EXPECT_NEAR(area(piece.buildings.at(0)->parts[0].footprint), 800, 0.1);
    settings.crs = "EPSG:999999";
    EXPECT_THAT(errorOf(file), HasSubstr("EPSG:999999"));
}

TEST_F(ReadFootprints, CoordinatesThatCannotBeDegreesAreAnError) {
    const auto file =
        geoJson(R"({"type":"Feature","properties":{"height":9},"geometry":{"type":"Polygon","coordinates":)"
                R"([[[980000,210000],[980100,210000],[980100,210100],[980000,210000]]]}})");
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("WGS 84"), HasSubstr("--crs")));
    settings.crs = "EPSG:2263";
    EXPECT_EQ(read(file).buildings.size(), 1U);
}

TEST_F(ReadFootprints, DegreesThatCallThemselvesFeetAreAnError) {
    const auto file = geoJson(feature(tests::sizedRectangle(0, 0, 10, 10), R"("height":9)"));
    for (const char* crs : {"EPSG:2263", "EPSG:3857", "EPSG:32618"}) {
        settings.crs = crs;
        EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("look like degrees"), HasSubstr("--crs"))) << crs;
    }
}

TEST_F(ReadFootprints, FilesThatCannotBeUsedAreOneClearError) {
    using testing::Not;
    const auto expectClear = [&](const std::filesystem::path& file) {
        const std::string text = errorOf(file);
        EXPECT_THAT(text, HasSubstr(file.filename().string()));
        EXPECT_THAT(text, Not(HasSubstr("\n")));
    };
    expectClear(folder.path("missing.geojson"));
    expectClear(folder.file("empty.geojson", ""));
    expectClear(folder.file("text.geojson", "These are not the buildings you are looking for.\n"));
    expectClear(folder.file("zero.shp", ""));
    expectClear(folder.file("nothing.geojson", R"({"type":"FeatureCollection","features":[]})"));
    expectClear(folder.file(
        "points.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1,2]}}]})"));
    expectClear(folder.file("none.osm", "<osm version=\"0.6\"></osm>"));
}

TEST_F(ReadFootprints, AMapWithoutBuildingsIsAnError) {
    tests::OsmText osm;
    osm.way(tests::sizedRectangle(0, 0, 10, 10), {{"building", "yes"}, {"location", "underground"}});
    EXPECT_THAT(errorOf(folder.file("cellar.osm", osm.xml())), HasSubstr("underground"));
}

TEST_F(ReadFootprints, CanBeStopped) {
    std::string features;
    for (int i = 0; i < 2000; ++i)
        features +=
            feature(tests::sizedRectangle(float(i) * 12, 0, 10, 10), R"("height":9)") + (i < 1999 ? "," : "");
    std::stop_source stop;
    stop.request_stop();
    NoProgress quiet;
    const auto result = readFootprints(geoJson(features), settings, quiet, stop.get_token());
    ASSERT_FALSE(result);
    EXPECT_TRUE(isCancelled(result.error()));
}

TEST_F(ReadFootprints, ProgressOnlyGrowsAndEndsAtOne) {
    tests::GrowingProgress progress;
    std::string features;
    for (int i = 0; i < 1000; ++i)
        features +=
            feature(tests::sizedRectangle(float(i) * 12, 0, 10, 10), R"("height":9)") + (i < 999 ? "," : "");
    ASSERT_TRUE(readFootprints(geoJson(features), settings, progress, {}));
    EXPECT_TRUE(progress.grew);
    EXPECT_DOUBLE_EQ(progress.last, 1);
}

}  // namespace
}  // namespace noonmark
