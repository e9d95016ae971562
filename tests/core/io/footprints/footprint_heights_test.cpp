#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <tuple>

#include "core/io/read_city.h"
#include "core/study/provenance/provenance.h"
#include "tests/core/io/footprint_files.h"

// Which field is the height, and in which unit.
namespace noonmark {
namespace {

using namespace tests;
using testing::ElementsAre;
using testing::HasSubstr;

double heightOf(const Building& building) {
    return double(building.parts[0].topM) - double(building.parts[0].bottomM);
}

TEST_F(ReadFootprints, FrenchHeightsAreRead) {
    const FilePiece piece =
        readGeoJson(feature(sizedRectangle(0, 0, 10, 10), R"("HAUTEUR":17.3,"NB_ETAGES":5)") + "," +
                    feature(sizedRectangle(20, 0, 10, 10),
                            R"("HAUTEUR":null,"Z_MIN_SOL":40.0,"Z_MIN_TOIT":52.5,"Z_MAX_TOIT":60.0)") +
                    "," + feature(sizedRectangle(40, 0, 10, 10), R"("HAUTEUR":null,"NB_ETAGES":4)"));
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

// As a WFS 2.0 writes buildings of INSPIRE: latitude first, the height two elements below its name.
TEST(InspireBuildings, StateTheirHeightsAsNestedLengths) {
    const auto building = [](int number, const char* heightM, double south) {
        return fmt::format(
            R"(<wfs:member><bu-core2d:Building gml:id="B{0}"><bu-base:heightAboveGround><bu-base:HeightAboveGround>
<bu-base:status>measured</bu-base:status><bu-base:value uom="m">{1}</bu-base:value></bu-base:HeightAboveGround></bu-base:heightAboveGround>
<bu-base:numberOfFloorsAboveGround>2</bu-base:numberOfFloorsAboveGround><bu-core2d:geometry2D><gml:Polygon gml:id="P{0}"
srsName="http://www.opengis.net/def/crs/EPSG/0/4258"><gml:exterior><gml:LinearRing><gml:posList>{2} -3.7 {2} -3.6997 {3} -3.6997 {3} -3.7 {2} -3.7</gml:posList>
</gml:LinearRing></gml:exterior></gml:Polygon></bu-core2d:geometry2D></bu-core2d:Building></wfs:member>)",
            number, heightM, south, south + 0.0002);
    };
    const TemporaryFolder folder;
    const auto file = folder.file(
        "buildings.gml",
        R"(<?xml version="1.0"?><wfs:FeatureCollection xmlns:wfs="http://www.opengis.net/wfs/2.0" xmlns:gml="http://www.opengis.net/gml/3.2"
xmlns:bu-core2d="http://inspire.ec.europa.eu/schemas/bu-core2d/4.0" xmlns:bu-base="http://inspire.ec.europa.eu/schemas/bu-base/4.0">)" +
            building(1, "17.5", 40.4) + building(2, "9.25", 40.401) + "</wfs:FeatureCollection>");
    NoProgress quiet;
    const auto read = readCity({file}, {}, quiet, {});
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->city.buildings.size(), 2U);
    EXPECT_NEAR(heightOf(*read->city.buildings[0]), 17.5, 1e-3);
    EXPECT_NEAR(heightOf(*read->city.buildings[1]), 9.25, 1e-3);
    EXPECT_THAT(whats(read->warnings), testing::Contains(HasSubstr("as in INSPIRE")));
}

TEST_F(ReadFootprints, BostonsHeightsAreFeet) {
    const FilePiece piece = readGeoJson(feature(
        sizedRectangle(0, 0, 10, 10), R"("BLDG_HGT_2010":"788.19","GRND_ELEV_2010":"14","FLOOR":60)"));
    EXPECT_NEAR(heightOf(*piece.buildings.at(0)), 788.19 * 0.3048, 1e-3);
}

TEST_F(ReadFootprints, TextWithADecimalCommaIsANumber) {
    const FilePiece piece = readGeoJson(feature(sizedRectangle(0, 0, 10, 10), R"("altezza":"12,5")") + "," +
                                        feature(sizedRectangle(20, 0, 10, 10), R"("altezza":"7,25 m")") +
                                        "," + feature(sizedRectangle(40, 0, 10, 10), R"("altezza":"1,250")"));
    EXPECT_NEAR(heightOf(*piece.buildings.at(0)), 12.5, 1e-4);
    EXPECT_NEAR(heightOf(*piece.buildings.at(1)), 7.25, 1e-4);
    EXPECT_NEAR(heightOf(*piece.buildings.at(2)), 9.6, 1e-4) << "a thousand?";
}

TEST_F(ReadFootprints, FieldsThatCouldBeHeightsAreListed) {
    std::string features;
    for (int i = 0; i < 20; ++i) {
        if (i > 0) features += ',';
        features += feature(
            sizedRectangle(float(20 * i), 0, 10, 10),
            fmt::format(R"("H_BAT":{},"NIV":"{}","FID_1":{},"AREA":{},"ANNEE":{},"USE":"home","CLASS":{})",
                        i == 0 ? -9999.0 : 4.5 + 0.5 * i, 1 + i % 6, i + 1, 100.5 + i, 1950 + i,
                        110 + 10 * (i % 4)));
    }
    const FilePiece piece = readGeoJson(features);
    ASSERT_EQ(piece.heights.unknown.size(), 2U);
    EXPECT_EQ(piece.heights.unknown[0], (UnknownField{"a.geojson", "NIV", 1, 6, true, 20}));
    EXPECT_EQ(piece.heights.unknown[1],
              (UnknownField{"a.geojson", "H_BAT", 5, 14, false, 19, FieldKind::heights}));
    EXPECT_THAT(whats(piece.warnings), testing::Contains(HasSubstr("NIV (1 to 6 in 20 features)")));

    settings.heightField = "h_bat";
    settings.levelsField = "NIV";
    const FilePiece named = readGeoJson(features);
    EXPECT_NEAR(heightOf(*named.buildings.at(1)), 5, 1e-4);
    EXPECT_NEAR(heightOf(*named.buildings.at(0)), 3.2, 1e-4) << "from its storeys";
    settings.levelsField = "NIVEAU";
    EXPECT_THAT(errorOf(geoJson(features)), HasSubstr("There is no field \"NIVEAU\""));
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

TEST_F(ReadFootprints, OnlyOfWhatWasUsedIsAnAssumptionSaid) {
    // New York's fields beside a height that outranks its own; without values, they are not used either.
    const FilePiece outranked =
        readGeoJson(feature(sizedRectangle(0, 0, 10, 10), R"("height":12,"heightroof":100,"groundelev":50)"));
    EXPECT_NEAR(heightOf(*outranked.buildings.at(0)), 12, 1e-3);
    EXPECT_THAT(whats(outranked.warnings), ElementsAre(HasSubstr("feet are assumed"))) << "of the ground";
    const FilePiece used = readGeoJson(feature(sizedRectangle(0, 0, 10, 10), R"("heightroof":100)") + "," +
                                       feature(sizedRectangle(20, 0, 10, 10), R"("heightroof":90)"));
    EXPECT_THAT(whats(used.warnings), ElementsAre(HasSubstr("metres are assumed, though New York's")));
}

TEST_F(ReadFootprints, ViennasUndersidesStandOnTheTerrainModel) {
    const FilePiece piece = readGeoJson(
        feature(sizedRectangle(0, 0, 10, 10), R"("O_KOTE":190.5,"U_KOTE":171.2,"HOEHE_DGM":171.0)") + "," +
        feature(sizedRectangle(20, 0, 10, 10), R"("O_KOTE":190.5,"U_KOTE":176,"HOEHE_DGM":171.0)"));
    EXPECT_NEAR(heightOf(*piece.buildings.at(0)), 19.5, 1e-3);
    EXPECT_NEAR(piece.buildings.at(0)->parts[0].bottomM, 0, 1e-3);
    EXPECT_NEAR(piece.buildings.at(1)->parts[0].bottomM, 5, 1e-3);
    EXPECT_NEAR(piece.buildings.at(1)->parts[0].topM, 19.5, 1e-3);
}

TEST_F(ReadFootprints, TheUserNamesFieldAndUnit) {
    const auto file = geoJson(feature(sizedRectangle(0, 0, 10, 10), R"("height":5,"eaves":100)") + "," +
                              feature(sizedRectangle(20, 0, 10, 10), R"("height":5,"eaves":"20 m")"));
    settings.heightField = "EAVES";
    settings.heightUnit = LengthUnit::feet;
    const FilePiece piece = read(file);
    EXPECT_NEAR(piece.buildings[0]->parts[0].topM, 30.48, 1e-4);
    EXPECT_NEAR(piece.buildings[1]->parts[0].topM, 20, 1e-4);
    settings.heightField = "roof_top";
    EXPECT_THAT(errorOf(file), testing::AllOf(HasSubstr("roof_top"), HasSubstr("eaves")));
}

TEST_F(ReadFootprints, TagsInGeoJsonMeanWhatTheyMeanInOpenStreetMap) {
    const FilePiece piece = readGeoJson(
        feature(sizedRectangle(0, 0, 40, 20), R"("@id":"way/5","building":"yes","height":"90")") + "," +
        feature(sizedRectangle(0, 0, 40, 20), R"("@id":"way/6","building:part":"yes","height":"20")") + "," +
        feature(sizedRectangle(80, 0, 40, 20), R"("@id":"way/7","leisure":"park")"));
    ASSERT_EQ(piece.buildings.size(), 1U);
    EXPECT_EQ(piece.buildings[0]->parts.size(), 1U);
    EXPECT_FLOAT_EQ(piece.buildings[0]->parts[0].topM, 20);
    EXPECT_THAT(whats(piece.warnings), ElementsAre(HasSubstr("not tagged as a building")));
}

std::string squares(int count, const std::function<std::string(int)>& properties) {
    std::string features;
    for (int i = 0; i < count; ++i)
        features += (i > 0 ? "," : "") + feature(sizedRectangle(float(20 * i), 0, 10, 10), properties(i));
    return features;
}

TEST_F(ReadFootprints, StoreysTellThatHeightsAreFeet) {
    const FilePiece piece = readGeoJson(
        squares(6, [](int i) { return fmt::format(R"("height":{},"num_floors":{})", 11 * (i + 1), i + 1); }));
    EXPECT_NEAR(heightOf(*piece.buildings.at(5)), 66 * 0.3048, 1e-3);
    EXPECT_THAT(whats(piece.warnings),
                testing::Contains(HasSubstr("feet are assumed, since its values are 11")));
    settings.heightUnit = LengthUnit::metres;
    EXPECT_NEAR(heightOf(*readGeoJson(squares(6,
                                              [](int i) {
                                                  return fmt::format(R"("height":{},"num_floors":{})",
                                                                     11 * (i + 1), i + 1);
                                              }))
                              .buildings.at(5)),
                66, 1e-3)
        << "the user's unit holds";
}

TEST_F(ReadFootprints, StoreysTellEveryUnit) {
    for (const double perMetre : {10.0, 100.0, 1000.0, 1 / 0.0254}) {
        const FilePiece piece = readGeoJson(squares(6, [&](int i) {
            return fmt::format(R"("height":{},"num_floors":{})", 3.3 * (i + 1) * perMetre, i + 1);
        }));
        EXPECT_NEAR(heightOf(*piece.buildings.at(5)), 6 * 3.3, 1e-2) << perMetre;
    }
}

// Half of them over 130 m is no town.
TEST_F(ReadFootprints, HeightsThatNoTownHasAreDoubted) {
    const auto town = [](double perMetre) {
        return squares(9, [=](int i) { return fmt::format(R"("height":{})", (9 + i) * perMetre); });
    };
    const auto doubtOf = [&](double perMetre) {
        const FilePiece piece = readGeoJson(town(perMetre));
        if (piece.heights.doubts.empty()) return std::string();
        EXPECT_THAT(whats(piece.warnings), testing::Contains(HasSubstr("unit of the heights is doubtful")));
        return describe(piece.heights.doubts[0]);
    };
    EXPECT_EQ(
        doubtOf(10),
        "a.geojson: height: half of its heights are over 130 m as they are read, in metres; they look like "
        "decimetres (13 m: --height-unit dm) or inches (3.3 m: --height-unit in) or feet (39.6 m: "
        "--height-unit ft)");
    EXPECT_THAT(doubtOf(100), HasSubstr("they look like centimetres (13 m: --height-unit cm)"));
    EXPECT_THAT(doubtOf(1000), HasSubstr("they look like millimetres (13 m: --height-unit mm)"));
    EXPECT_EQ(doubtOf(1), "");
    settings.heightUnit = LengthUnit::metres;
    EXPECT_EQ(doubtOf(10), "") << "the user's unit holds";
}

TEST_F(ReadFootprints, ANameThatEndsInInIsOneOfInchesWhereItsValuesSaySo) {
    const auto town = [](double perMetre) {
        return squares(9, [=](int i) { return fmt::format(R"("height_in":{})", (6 + i) * perMetre); });
    };
    const FilePiece inches = readGeoJson(town(1 / 0.0254));
    EXPECT_NEAR(heightOf(*inches.buildings.at(8)), 14, 1e-3);
    EXPECT_THAT(whats(inches.warnings), testing::Contains(HasSubstr("inches are assumed, since its name")));
    const FilePiece cut = readGeoJson(town(1 / 0.3048));
    ASSERT_EQ(cut.heights.doubts.size(), 1U);
    EXPECT_THAT(cut.heights.doubts[0].why, HasSubstr("breaks off before its unit"));
    // Towers in feet would be houses in inches: neither is taken, both are named.
    const FilePiece towers =
        readGeoJson(squares(9, [](int i) { return fmt::format(R"("height_in":{})", 100 + 10 * i); }));
    EXPECT_NEAR(heightOf(*towers.buildings.at(8)), 180, 1e-3);
    ASSERT_EQ(towers.heights.doubts.size(), 1U);
    EXPECT_THAT(towers.heights.doubts[0].why, HasSubstr("--height-unit ft"));
    EXPECT_THAT(towers.heights.doubts[0].why, HasSubstr("--height-unit in"));
}

TEST_F(ReadFootprints, AHeightOfTheRoofAloneIsNotThatOfTheBuilding) {
    const FilePiece low = readGeoJson(squares(6, [](int) { return std::string(R"("roof_height":2.0)"); }));
    EXPECT_NEAR(heightOf(*low.buildings.at(0)), 9.6, 1e-3);
    EXPECT_THAT(whats(low.warnings), testing::Contains(HasSubstr("height of the roof alone")));
    const FilePiece high = readGeoJson(squares(6, [](int) { return std::string(R"("roof_height":12.0)"); }));
    EXPECT_NEAR(heightOf(*high.buildings.at(0)), 12, 1e-3);
}

TEST_F(ReadFootprints, AnotherHeightTellsTheUnit) {
    const FilePiece piece = readGeoJson(squares(6, [](int i) {
        return i < 5 ? fmt::format(R"("height":{},"maximum_roof_height":{})", 3 * (i + 1), 10 * (i + 1))
                     : std::string(R"("height":null,"maximum_roof_height":50)");
    }));
    EXPECT_NEAR(heightOf(*piece.buildings.at(5)), 15.24, 1e-3);
}

TEST_F(ReadFootprints, HeightsThatRepeatTheStoreysAreStoreys) {
    const FilePiece piece = readGeoJson(
        squares(6, [](int i) { return fmt::format(R"("height":{0},"num_floors":{0})", 2 * i + 2); }));
    EXPECT_NEAR(heightOf(*piece.buildings.at(5)), 12 * 3.2, 1e-3);
    EXPECT_THAT(whats(piece.warnings), testing::Contains(HasSubstr("repeat the storeys")));
}

TEST_F(ReadFootprints, FeaturesOfAnotherKindAreLeftOutAndReported) {
    const FilePiece piece = readGeoJson(squares(6, [](int i) {
        return fmt::format(R"("height":9,"type":"{}")", i < 4 ? "Building" : "District System");
    }));
    EXPECT_EQ(piece.buildings.size(), 4U);
    EXPECT_THAT(whats(piece.warnings), testing::Contains(HasSubstr("District System")));
    EXPECT_EQ(
        readGeoJson(
            squares(
                6, [](int i) { return fmt::format(R"("height":9,"type":"{}")", i < 4 ? "shed" : "garage"); }))
            .buildings.size(),
        6U)
        << "kinds of buildings";
}

std::string solidText(LonLat around) {
    const auto at = [&](double x, double y) { return Frame(around).lonLatFromLocal(glm::dvec2(x, y)); };
    const auto face = [](const std::vector<std::pair<LonLat, double>>& points) {
        std::string text;
        for (const auto& [place, z] : points)
            text += fmt::format("[{:.9f},{:.9f},{}],", place.lonDeg, place.latDeg, z);
        text += fmt::format("[{:.9f},{:.9f},{}]", points[0].first.lonDeg, points[0].first.latDeg,
                            points[0].second);
        return "[[" + text + "]]";
    };
    const LonLat a = at(0, 0), b = at(10, 0), c = at(10, 10), d = at(0, 10);
    return face({{a, 100}, {d, 100}, {c, 100}, {b, 100}}) + "," +
           face({{a, 117}, {b, 117}, {c, 117}, {d, 117}}) + "," +
           face({{a, 100}, {b, 100}, {b, 117}, {a, 117}});
}

TEST_F(ReadFootprints, ASolidIsAsHighAsItsFaces) {
    const FilePiece piece =
        readGeoJson(R"({"type":"Feature","properties":{},"geometry":{"type":"MultiPolygon","coordinates":[)" +
                    solidText(manhattan) + "]}}");
    EXPECT_NEAR(heightOf(*piece.buildings.at(0)), 17, 1e-3);
    EXPECT_EQ(piece.buildings.at(0)->parts.at(0).heightSource, HeightSource::measured);
    EXPECT_TRUE(std::ranges::none_of(piece.warnings, [](const Warning& warning) {
        return warning.kind == WarningKind::dropped;
    })) << "walls have no outline, and nothing of them is lost";
}

std::string flatOutline(int i, double z, const std::string& properties) {
    const Frame frame(manhattan);
    std::string ring;
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}, {0.0, 0.0}}) {
        const LonLat place = frame.lonLatFromLocal(glm::dvec2(x + 20 * i, y));
        ring += fmt::format("{}[{:.9f},{:.9f},{}]", ring.empty() ? "" : ",", place.lonDeg, place.latDeg, z);
    }
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"Polygon","coordinates":[[)" + ring + "]]}}";
}

TEST_F(ReadFootprints, OutlinesAtTheRoofGiveHeightsAboveTheStatedGround) {
    std::string features;
    for (int i = 0; i < 6; ++i)
        features += (i > 0 ? "," : "") + flatOutline(i, 108 + i, R"("Z_MIN_SOL":100,"HAUTEUR":null)");
    const FilePiece piece = readGeoJson(features);
    EXPECT_NEAR(heightOf(*piece.buildings.at(5)), 13, 1e-3);
    EXPECT_EQ(piece.heights.fields.at(0).field, "outline Z - Z_MIN_SOL");
}

TEST_F(ReadFootprints, OutlinesAtAnUnknownHeightAreOfferedAndCanBeChosen) {
    std::string features;
    for (int i = 0; i < 6; ++i) features += (i > 0 ? "," : "") + flatOutline(i, 17.5 + i, "");
    const FilePiece offered = readGeoJson(features);
    ASSERT_EQ(offered.heights.unknown.size(), 1U);
    EXPECT_EQ(selectingOptions(offered.heights.unknown[0]), "--height-field 'outline Z'");
    EXPECT_NEAR(heightOf(*offered.buildings.at(0)), 9.6, 1e-3);
    settings.heightField = "outline Z";
    EXPECT_NEAR(heightOf(*readGeoJson(features).buildings.at(5)), 22.5, 1e-3);
}

TEST_F(ReadFootprints, AnOfferedOutlineZCanBeChosenInALayerOfAnyGeometry) {
    const auto file = folder.path("any.gpkg");
    {
        const GdalCalls calls;
        const GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GPKG")->Create(
            file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRSpatialReference wgs84;
        wgs84.SetWellKnownGeogCS("WGS84");
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        OGRLayer* const layer = dataset->CreateLayer("town", &wgs84, wkbUnknown, nullptr);
        for (int i = 0; i < 6; ++i) {
            const OGRFeatureUniquePtr made(OGRFeature::CreateFeature(layer->GetLayerDefn()));
            const auto document = flatOutline(i, 17.5 + i, "");
            const auto geometry = document.substr(document.find(R"("geometry":)") + 11);
            made->SetGeometryDirectly(
                OGRGeometryFactory::createFromGeoJson(geometry.substr(0, geometry.size() - 1).c_str()));
            ASSERT_EQ(layer->CreateFeature(made.get()), OGRERR_NONE);
        }
    }
    EXPECT_EQ(selectingOptions(read(file).heights.unknown.at(0)), "--height-field 'outline Z'");
    settings.heightField = "outline Z";
    EXPECT_NEAR(heightOf(*read(file).buildings.at(5)), 22.5, 1e-3);
}

TEST_F(ReadFootprints, KmlStatesWhatItsAltitudesCountFrom) {
    const auto polygon = [](const char* mode, const char* extrude, double x, double z) {
        return fmt::format(
            "<Placemark><Polygon>{0}{1}<outerBoundaryIs><LinearRing><coordinates>{2},40.75,{3} "
            "{4},40.75,{3} {4},40.7501,{3} {2},40.75,{3}</coordinates></LinearRing></outerBoundaryIs>"
            "</Polygon></Placemark>",
            extrude, mode, -73.98 + x, z, -73.9799 + x);
    };
    const std::string relative = "<altitudeMode>relativeToGround</altitudeMode>";
    const FilePiece piece = read(folder.file(
        "a.kml", "<kml xmlns='http://www.opengis.net/kml/2.2'><Document><Folder><name>x</name>" +
                     polygon(relative.c_str(), "<extrude>1</extrude>", 0, 17) +
                     polygon(relative.c_str(), "", 0.001, 25) +
                     polygon("<altitudeMode>absolute</altitudeMode>", "<extrude>1</extrude>", 0.002, 1784) +
                     polygon("", "", 0.003, 12) + "</Folder></Document></kml>"));
    ASSERT_EQ(piece.buildings.size(), 4U);
    EXPECT_NEAR(heightOf(*piece.buildings[0]), 17, 1e-3);
    EXPECT_NEAR(heightOf(*piece.buildings[1]), 25, 1e-3);
    EXPECT_NEAR(heightOf(*piece.buildings[2]), 9.6, 1e-3) << "an elevation without that of the ground";
    EXPECT_NEAR(heightOf(*piece.buildings[3]), 9.6, 1e-3) << "clamped to the ground";
    EXPECT_THAT(whats(piece.warnings), testing::Contains(HasSubstr("floats")));
}

TEST_F(ReadFootprints, DegreesOfAFlatGeobufWithoutAReferenceSystemAreKnown) {
    writeRectangle(folder.path("a.fgb"), "FlatGeobuf", "", {{"height", 12.5}});
    const FilePiece piece = read(folder.path("a.fgb"));
    EXPECT_NEAR(heightOf(*piece.buildings.at(0)), 12.5, 1e-3);
    EXPECT_THAT(whats(piece.warnings), testing::Contains(HasSubstr("taken for degrees (--crs EPSG:4326)")));
}

// As QGIS (SchemaData) and tokml (Data) write fields, which GDAL's reader of KML leaves out.
TEST_F(ReadFootprints, FieldsOfKmlPlacemarksAreRead) {
    const auto placemark = [](const char* data, double x) {
        return fmt::format(
            "<Placemark><ExtendedData>{0}</ExtendedData><MultiGeometry><Polygon><outerBoundaryIs><LinearRing>"
            "<coordinates>{1},40.75 {2},40.75 {2},40.7501 {1},40.75</coordinates></LinearRing>"
            "</outerBoundaryIs></Polygon></MultiGeometry></Placemark>",
            data, -73.98 + x, -73.9799 + x);
    };
    const FilePiece piece = read(folder.file(
        "a.kml",
        "<kml xmlns='http://www.opengis.net/kml/2.2'><Document><Folder><name>x</name>" +
            placemark("<SchemaData schemaUrl='#s'><SimpleData name='height'>21.5</SimpleData></SchemaData>",
                      0) +
            placemark("<Data name='height'><value>30 m</value></Data>", 0.001) +
            "</Folder></Document></kml>"));
    ASSERT_EQ(piece.buildings.size(), 2U);
    EXPECT_NEAR(heightOf(*piece.buildings[0]), 21.5, 1e-3);
    EXPECT_NEAR(heightOf(*piece.buildings[1]), 30, 1e-3);
}

// A table in another encoding, as those of the nineties are, and nothing says so.
std::filesystem::path writeUnstated(tests::TemporaryFolder& folder, std::string_view placeholder,
                                    std::string_view bytes) {
    writeRectangle(folder.path("a.shp"), "ESRI Shapefile", "EPSG:4326", {{std::string(placeholder), 12.5}});
    std::ifstream stream(folder.path("a.dbf"), std::ios::binary);
    std::string table{std::istreambuf_iterator<char>(stream), {}};
    table.replace(table.find(placeholder), placeholder.size(), bytes);
    table[29] = 0;  // no code page
    std::ignore = folder.file("a.dbf", table);
    std::filesystem::remove(folder.path("a.cpg"));
    return folder.path("a.shp");
}

TEST_F(ReadFootprints, NamesInLatin1AreKnownWithoutACpg) {
    EXPECT_NEAR(heightOf(*read(writeUnstated(folder, "Hxhe_m", "H\xF6he_m")).buildings.at(0)), 12.5, 1e-3);
}

TEST_F(ReadFootprints, NamesInBig5AreKnownWithoutACpg) {
    const FilePiece piece = read(writeUnstated(folder, "abcd", "\xBC\xD3\xB0\xAA"));
    EXPECT_NEAR(heightOf(*piece.buildings.at(0)), 12.5, 1e-3);
    EXPECT_TRUE(std::ranges::any_of(piece.warnings, [](const Warning& one) {
        return one.what.find("they are read as Big5") != one.what.npos;
    }));
}

TEST_F(ReadFootprints, AFolderOfShapefilesIsADataset) {
    std::filesystem::create_directory(folder.path("town"));
    writeRectangle(folder.path("town") / "houses.shp", "ESRI Shapefile", "EPSG:4326", {{"height", 12}});
    NoProgress quiet;
    const auto city = readCity({folder.path("town")}, {}, quiet, {});
    ASSERT_TRUE(city) << city.error().text();
    EXPECT_EQ(city->city.buildings.size(), 1U);
    const auto inputs = describeInputFiles(folder.path("town"));
    ASSERT_TRUE(inputs) << inputs.error().text();
    ASSERT_EQ(inputs->size(), 1U);
    EXPECT_EQ(inputs->front().sha256.size(), 64U);
}

// A GeoPackage may keep the telling name as the alias of a field.
TEST_F(ReadFootprints, AnAliasSaysWhatAFieldHolds) {
    const auto file = folder.path("a.gpkg");
    writeRectangle(file, "GPKG", "EPSG:4326", {{"c1", 40}});
    {
        const GdalCalls calls;
        const GDALDatasetUniquePtr dataset(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
        for (const char* statement : {"CREATE TABLE gpkg_data_columns (table_name TEXT NOT NULL, column_name "
                                      "TEXT NOT NULL, name TEXT, title "
                                      "TEXT, description TEXT, mime_type TEXT, constraint_name TEXT, PRIMARY "
                                      "KEY (table_name, column_name))",
                                      "INSERT INTO gpkg_data_columns VALUES ('houses', 'c1', 'Building "
                                      "height (ft)', NULL, NULL, NULL, NULL)"})
            dataset->ExecuteSQL(statement, nullptr, nullptr);
    }
    EXPECT_NEAR(heightOf(*read(file).buildings.at(0)), 12.192, 1e-3);
    settings.heightField = "c1";
    EXPECT_NEAR(heightOf(*read(file).buildings.at(0)), 12.192, 1e-3) << "by its own name too";
}

}  // namespace
}  // namespace noonmark
