#include "core/io/settings/read_settings.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

ReadSettings everySetting() {
    ReadSettings reading;
    reading.heightField = "roof \"height\"";
    reading.heightUnit = LengthUnit::usSurveyFeet;
    reading.metresPerLevel = 3.1;
    reading.defaultHeightM = 7.7;
    reading.levelsField = "storeys";
    reading.terrainFromBases = TerrainFromBases::never;
    reading.stand = Stand::absolute;
    reading.terrainShows = TerrainShows::surface;
    reading.heightsFromSurface = true;
    reading.surfaceToleranceM = 0.25;
    reading.extent = LonLatBox{-73.99, 40.75, -73.97, 40.77};
    reading.layer = "buildings";
    reading.crs = "EPSG:2263";
    reading.lod = "2.2";
    reading.farAwayM = 12345.678;
    reading.upAxis = UpAxis::z;
    reading.meshUnit = LengthUnit::centimetres;
    reading.meshNorthDeg = -28.9;
    reading.meshAnchor = LonLat{-73.98, 40.76};
    return reading;
}

TEST(ReadSettingsText, ComesBackToTheLastBit) {
    const ReadSettings back = readSettingsFrom(formatText(everySetting())).value();
    EXPECT_EQ(formatText(back), formatText(everySetting()));
    EXPECT_EQ(back.farAwayM, 12345.678);
    EXPECT_EQ(back.meshAnchor, (LonLat{-73.98, 40.76}));
    EXPECT_EQ(back.heightField, "roof \"height\"");
    EXPECT_EQ(back.heightUnit, LengthUnit::usSurveyFeet);
    EXPECT_EQ(back.stand, Stand::absolute);
    EXPECT_EQ(back.terrainShows, TerrainShows::surface);
    EXPECT_TRUE(back.heightsFromSurface);
    EXPECT_EQ(back.extent->eastDeg, -73.97);
    EXPECT_EQ(formatText(readSettingsFrom("").value()), "");
}

// As all versions write and read it.
TEST(ReadSettingsText, TheAxisIsNamedByWhetherZPointsUp) {
    ReadSettings reading;
    reading.upAxis = UpAxis::z;
    EXPECT_EQ(formatText(reading), R"({"z_up":true})");
    EXPECT_EQ(readSettingsFrom(R"({"z_up": false})")->upAxis, UpAxis::y);
}

TEST(ReadSettingsText, DefaultsAreLeftOut) { EXPECT_EQ(formatText(ReadSettings{}), ""); }

TEST(ReadSettingsText, OtherTextIsNoSettings) {
    for (const char* text :
         {"crs", R"({"mesh_unit": 9})", R"({"crs": 4326})", "[]", "7", R"({"layer": null})"})
        EXPECT_FALSE(readSettingsFrom(text)) << text;
}

}  // namespace
}  // namespace noonmark
