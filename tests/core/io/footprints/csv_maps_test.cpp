#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/read_city.h"
#include "tests/core/io/temporary_folder.h"

// Tables of buildings as people export them.
namespace noonmark {
namespace {

using testing::HasSubstr;

class CsvMaps : public testing::Test {
protected:
    Result<CityRead> readTable(const std::string& content, const ReadSettings& settings = {}) {
        NoProgress quiet;
        return readCity({folder.file("table.csv", content)}, settings, quiet, {});
    }
    static std::string saidBy(const CityRead& read) {
        std::string text;
        for (const Warning& warning : read.warnings) text += warning.what + "\n";
        return text;
    }
    tests::TemporaryFolder folder;
};

constexpr const char* outlineText =
    "\"POLYGON((4.90 52.37,4.9002 52.37,4.9002 52.3701,4.90 52.3701,4.90 52.37))\"\n";

TEST_F(CsvMaps, SemicolonsAndDecimalCommasAreRead) {
    const auto city = readTable(std::string("id;height;WKT\n1;12,5;") + outlineText);
    ASSERT_TRUE(city) << city.error().text();
    ASSERT_EQ(city->city.buildings.size(), 1U);
    EXPECT_NEAR(topM(*city->city.buildings[0]), 12.5, 1e-4);
    EXPECT_THAT(saidBy(*city), HasSubstr("taken for degrees (--crs EPSG:4326)"));
    EXPECT_EQ(city->crs, "WGS 84, guessed from the numbers");
}

// PostGIS writes the number of the system before the outline.
TEST_F(CsvMaps, TheSystemOfOutlinesOfPostgisIsTheirNumber) {
    const auto city = readTable(
        "id,height,geom\n1,20,\"SRID=25833;POLYGON((390000 5819000,390020 5819000,390020 5819020,390000 "
        "5819020,390000 5819000))\"\n");
    ASSERT_TRUE(city) << city.error().text();
    ASSERT_EQ(city->city.buildings.size(), 1U);
    EXPECT_NEAR(topM(*city->city.buildings[0]), 20, 1e-4);
    EXPECT_NEAR(city->city.frame.origin().lonDeg, 13.37929, 0.0001);
    EXPECT_NEAR(city->city.frame.origin().latDeg, 52.51010, 0.0001);
    EXPECT_THAT(city->crs, HasSubstr("UTM zone 33N"));
}

TEST_F(CsvMaps, OutlinesMayBeCalledGeometry) {
    for (const char* name : {"geom", "geometry", "the_geom", "WKT"}) {
        const auto city = readTable(std::string("id,height,") + name + "\n1,8," + outlineText);
        ASSERT_TRUE(city) << name << city.error().text();
        EXPECT_EQ(city->city.buildings.size(), 1U) << name;
    }
}

// Under any name, in any place; texts with dividers before it are not counted through.
TEST_F(CsvMaps, OutlinesAreFoundByTheirText) {
    for (const char* name : {"Umriss", "形状", "\"Shape Text\""}) {
        const auto city = readTable(std::string("id,") + name +
                                    ",height\n1,\"POLYGON((4.90 52.37,4.9002 "
                                    "52.37,4.9002 52.3701,4.90 52.3701,4.90 52.37))\",8\n");
        ASSERT_TRUE(city) << name << city.error().text();
        EXPECT_EQ(city->city.buildings.size(), 1U) << name;
        EXPECT_NEAR(topM(*city->city.buildings[0]), 8, 1e-4);
    }
    const auto city =
        readTable(std::string("note,outline,height\n\"a,b\",") +
                  std::string(outlineText).substr(0, std::string(outlineText).size() - 1) + ",8\n");
    ASSERT_FALSE(city);
    EXPECT_THAT(city.error().text(), HasSubstr("no column has outlines"));
}

TEST_F(CsvMaps, AMapInMetresAsksForItsSystem) {
    const std::string metres =
        "id,height,WKT\n1,8,\"POLYGON((121000 487000,121010 487000,121010 487010,121000 487000))\"\n";
    const auto unknown = readTable(metres);
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.error().advice, HasSubstr("--crs"));
    const auto known = readTable(metres, {.crs = "EPSG:28992"});
    ASSERT_TRUE(known) << known.error().text();
    EXPECT_EQ(known->crs, "Amersfoort / RD New, as --crs states");
}

TEST_F(CsvMaps, PointsAreNoOutlinesAndWhatIsMissingIsReported) {
    const auto city = readTable("id,height,lon,lat\n1,8,4.9,52.37\n");
    ASSERT_FALSE(city);
    EXPECT_THAT(city.error().text(), HasSubstr("POLYGON"));
}

TEST_F(CsvMaps, EncodingsAreGuessedAndReported) {
    const auto latin = readTable(std::string("name;height;WKT\nStra\xDF"
                                             "e;12;") +
                                 outlineText);
    ASSERT_TRUE(latin) << latin.error().text();
    EXPECT_EQ(latin->city.buildings.at(0)->name, "Straße");
    EXPECT_THAT(saidBy(*latin), HasSubstr("read as Windows-1252"));
    const auto japanese =
        readTable(std::string("name;\x8D\x82\x82\xB3;WKT\n\x93\x8C\x8B\x9E;12;") + outlineText);
    ASSERT_TRUE(japanese) << japanese.error().text();
    EXPECT_EQ(japanese->city.buildings.at(0)->name, "東京");
    EXPECT_NEAR(topM(*japanese->city.buildings[0]), 12, 1e-4);
    EXPECT_THAT(saidBy(*japanese), HasSubstr("read as CP932"));
}

TEST_F(CsvMaps, BrokenOutlinesAreListedOrRefused) {
    const auto city = readTable(std::string("id,height,WKT\n1,8,POLYGON((nonsense\n2,9,") + outlineText);
    ASSERT_TRUE(city) << city.error().text();
    EXPECT_EQ(city->city.buildings.size(), 1U);
    EXPECT_FALSE(readTable("id,height,WKT\n1,8,POLYGON((nonsense\n"));
}

}  // namespace
}  // namespace noonmark
