#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace noonmark
