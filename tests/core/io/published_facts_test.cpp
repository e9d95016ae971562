#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/io/read_city.h"
#include "tests/shared/shared_data.h"

// What is read of every file of the shared data, held against facts that were stated beforehand (its README).
namespace noonmark {
namespace {

using testing::Contains;
using testing::HasSubstr;

struct PublishedFact {
    const char* file;
    std::size_t buildings;    // 0: not stated
    double tallestM, within;  // 0: not stated
    const char* warning;      // part of one; empty: none is asked for
};

constexpr PublishedFact publishedFacts[] = {
    {"midtown_manhattan/midtown_manhattan.osm.pbf", 0, 443.2, 0.05, ""},
    {"monaco/monaco-latest.osm.pbf", 0, 0, 0, ""},
    {"delfshaven/3-20-DELFSHAVEN.city.json", 853, 41.16, 0.01, ""},
    {"goteborg/buildings.shp", 137, 9.6, 0.01, "no field of heights"},
    {"world/chicago_loop.osm.pbf", 0, 527, 0.5, ""},
    {"world/prague_bubenec.gpkg", 144, 0, 0, "--layer"},
    {"world/aveyron/BATIMENT.shp", 2273, 20.3, 0.01, ""},
    {"world/alexandria/buildings.geojson", 84, 17.53, 0.01, ""},
    {"world/golden_colorado.geojson", 35, 15.24, 0.25, "District System"},
    {"world/frankfurt_passage.osm", 1, 5, 0.01, ""},
};

class PublishedFacts : public testing::Test {
protected:
    bool readFile(const char* file, ReadSettings settings = {}) {
        const auto path = tests::sharedData(file);
        if (!path) return false;
        NoProgress quiet;
        auto result = readCity({*path}, settings, quiet, {});
        EXPECT_TRUE(result) << result.error().text();
        if (result) read = *std::move(result);
        return result.has_value();
    }
    [[nodiscard]] double tallestM() const {
        const std::vector<double> all = heights();
        return all.empty() ? 0 : all.back();
    }
    static double lowestM(const Building& building) {
        float lowest = 1e30F;
        for (const Part& part : building.parts) lowest = std::min(lowest, part.bottomM);
        return double(lowest);
    }
    [[nodiscard]] std::vector<std::string> warningLines() const {
        std::vector<std::string> lines;
        for (const Warning& warning : read.warnings) lines.push_back(warning.where + ": " + warning.what);
        return lines;
    }
    [[nodiscard]] std::vector<double> heights() const {
        std::vector<double> all;
        for (const auto& building : read.city.buildings)
            all.push_back(double(topM(*building)) - lowestM(*building));
        std::ranges::sort(all);
        return all;
    }
    [[nodiscard]] double areaM2() const {
        double sum = 0;
        for (const auto& building : read.city.buildings)
            for (const Part& part : building->parts) sum += area(part.footprint);
        return sum;
    }
    CityRead read;
};

TEST_F(PublishedFacts, HoldForEveryMapOfBuildings) {
    for (const PublishedFact& fact : publishedFacts) {
        SCOPED_TRACE(fact.file);
        if (!tests::sharedData(fact.file)) GTEST_SKIP() << "shared data is missing";
        // On level ground, where a building is as high as its data says.
        if (!readFile(fact.file, {.terrainFromBases = TerrainFromBases::never})) continue;
        if (fact.buildings > 0) {
            EXPECT_EQ(read.city.buildings.size(), fact.buildings);
        }
        if (fact.tallestM > 0) {
            EXPECT_NEAR(tallestM(), fact.tallestM, fact.within);
        }
        if (*fact.warning != '\0') {
            EXPECT_THAT(warningLines(), Contains(HasSubstr(fact.warning)));
        }
    }
}

TEST_F(PublishedFacts, PraguesBuildingsHaveTheirTrueArea) {
    if (!tests::sharedData("world/prague_bubenec.gpkg")) GTEST_SKIP() << "shared data is missing";
    ASSERT_TRUE(readFile("world/prague_bubenec.gpkg"));
    EXPECT_NEAR(areaM2(), 43151, 50);
    ASSERT_TRUE(readFile("world/prague_bubenec.gpkg", {.layer = "plots"}));
    EXPECT_GT(read.features, 400U) << "another layer when it is named";
}

TEST_F(PublishedFacts, ExtrudedPolygonsOfKmlHaveTheirAltitudeAsHeight) {
    if (!tests::sharedData("world/KML_Samples.kml")) GTEST_SKIP() << "shared data is missing";
    ASSERT_TRUE(readFile("world/KML_Samples.kml"));
    EXPECT_THAT(heights(),
                testing::ElementsAre(testing::DoubleNear(17, 0.01), testing::DoubleNear(17, 0.01),
                                     testing::DoubleNear(19, 0.01), testing::DoubleNear(25, 0.01)));
    EXPECT_NEAR(read.city.frame.origin().lonDeg, -122.085, 0.01) << "the campus, not between continents";
    EXPECT_THAT(warningLines(), Contains(HasSubstr("from the middle")));
}

TEST_F(PublishedFacts, ThePassageOfFrankfurtIsOpenBelow) {
    if (!tests::sharedData("world/frankfurt_passage.osm")) GTEST_SKIP() << "shared data is missing";
    ASSERT_TRUE(readFile("world/frankfurt_passage.osm"));
    double openM2 = 0;
    for (const Part& part : read.city.buildings.at(0)->parts) {
        if (!part.isOverhanging) continue;
        EXPECT_NEAR(part.bottomM, 2.8, 0.01);
        openM2 += area(part.footprint);
    }
    EXPECT_NEAR(openM2, 201.6, 1);
}

TEST_F(PublishedFacts, TheHallOfTheFerryBuildingIsNotAsHighAsItsTower) {
    if (!tests::sharedData("world/ferry_building.osm")) GTEST_SKIP() << "shared data is missing";
    ASSERT_TRUE(readFile("world/ferry_building.osm"));
    double highM2 = 0, tallest = 0;
    for (const auto& building : read.city.buildings)
        for (const Part& part : building->parts) {
            tallest = std::max(tallest, double(part.topM));
            if (part.topM > 20 && !part.isOverhanging) highM2 += area(part.footprint);
        }
    EXPECT_NEAR(tallest, 83.1, 0.1);
    EXPECT_LT(highM2, 1000);
}

TEST_F(PublishedFacts, DrawingsOfAlexandriaAreInTheirUnit) {
    const auto file = tests::sharedData("world/alexandria/alexandria_insunits21_usft.dxf");
    if (!file) GTEST_SKIP() << "shared data is missing";
    ReadSettings settings;
    settings.farAwayM = 2e6;
    settings.frame = Frame({-77.05, 38.81});
    NoProgress quiet;
    const auto result = readCity({*file}, settings, quiet, {});
    ASSERT_TRUE(result) << result.error().text();
    read = *result;
    double sum = 0;
    for (const double height : heights()) sum += height;
    EXPECT_NEAR(sum, 570.765, 0.5);
    EXPECT_NEAR(areaM2(), 25503.4, 30);
}

TEST_F(PublishedFacts, TerrainsHaveTheirElevations) {
    const auto file = tests::sharedData("goteborg/DEM_KRbig.tif");
    if (!file) GTEST_SKIP() << "shared data is missing";
    ASSERT_TRUE(readFile("goteborg/DEM_KRbig.tif"));
    ASSERT_TRUE(read.city.terrain);
    const auto [low, high] = std::ranges::minmax(read.city.terrain->elevationM);
    EXPECT_NEAR(low + read.city.frame.originElevationM(), 0, 1);
    EXPECT_NEAR(high + read.city.frame.originElevationM(), 23, 1);
}

}  // namespace
}  // namespace noonmark
