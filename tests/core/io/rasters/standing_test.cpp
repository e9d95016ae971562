#include "core/io/terrain/standing.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/io/read_city.h"
#include "core/io/terrain/buildings_on_terrain.h"
#include "core/io/write_city.h"
#include "tests/core/city/mesh_fixtures.h"
#include "tests/core/io/city_reading.h"
#include "tests/core/io/cityjson_fixtures.h"
#include "tests/core/io/footprint_files.h"
#include "tests/core/io/terrain_files.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

constexpr double houseSideM = 10, heightM = 12;

// The ground rises by 1 in 10 towards the east.
double steepSlope(double x, double /*y*/) { return 100 + x / 10; }

// Nine houses in rows, 12 m high.
std::vector<glm::dvec2> corners() {
    std::vector<glm::dvec2> all;
    for (int row = -1; row <= 1; ++row)
        for (int column = -1; column <= 1; ++column) all.emplace_back(column * 50, row * 50);
    return all;
}

class StandingTest : public tests::CityReading {
protected:
    std::filesystem::path hill(double (*ground)(double, double) = steepSlope) {
        return writeTerrain(folder.path("hill.tif"), manhattan, ground);
    }

    // Footprints whose ground elevation misses the lowest ground below each by a gap.
    std::filesystem::path footprints(const std::function<double(int)>& gapM) {
        std::string features;
        int i = 0;
        for (const glm::dvec2 low : corners()) {
            const double ground = steepSlope(low.x, low.y) + gapM(i++);
            features += (features.empty() ? "" : ",") +
                        feature(sizedRectangle(float(low.x), float(low.y), houseSideM, houseSideM),
                                fmt::format(R"("height":{},"ground_elevation":{})", heightM, ground));
        }
        return folder.file("houses.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
    }

    // The same houses as boxes of a mesh; `base` is that of a house by its place.
    std::string boxesObj(const std::function<double(glm::dvec2)>& base) {
        std::string text;
        int vertices = 0, number = 0;
        for (const glm::dvec2 low : corners())
            addBox(text, vertices, fmt::format("house{}", number++), {low.x, low.y, base(low)},
                   {low.x + houseSideM, low.y + houseSideM, base(low) + heightM});
        return text;
    }
    static void addBox(std::string& text, int& vertices, const std::string& name, glm::dvec3 low,
                       glm::dvec3 high) {
        const TriangleMesh mesh = box(glm::vec3(low), glm::vec3(high));
        text += "o " + name + "\n";
        for (const glm::vec3 v : mesh.vertices) text += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
        for (const glm::uvec3 t : mesh.triangles)
            text += fmt::format("f {} {} {}\n", vertices + int(t.x) + 1, vertices + int(t.y) + 1,
                                vertices + int(t.z) + 1);
        vertices += int(mesh.vertices.size());
    }
    CityRead readObj(const std::string& text, bool withHill) {
        settings.upAxis = UpAxis::z;
        settings.meshAnchor = manhattan;
        std::vector<std::filesystem::path> files{folder.file("town.obj", text)};
        if (withHill) files.push_back(hill());
        return read(files);
    }

    // Every building begins `aboveM` above the lowest ground under it and keeps its height.
    static void expectOnGround(const CityRead& read, double aboveM = 0, double toleranceM = 0.06) {
        ASSERT_NE(read.city.terrain, nullptr);
        ASSERT_EQ(read.city.buildings.size(), 9U);
        for (const auto& building : read.city.buildings) {
            const double lowest = double(findLowestGround(*building, *read.city.terrain));
            EXPECT_NEAR(double(topM(*building)) - lowest, heightM + aboveM, toleranceM);
            EXPECT_LE(double(building->parts[0].bottomM) - lowest, std::max(0.0, aboveM) + toleranceM);
            EXPECT_FALSE(building->parts[0].isOverhanging);
        }
    }
    static bool warns(const CityRead& read, std::string_view what) {
        return std::ranges::any_of(
            read.warnings, [&](const Warning& one) { return one.what.find(what) != std::string::npos; });
    }

    TemporaryFolder folder;
};

TEST_F(StandingTest, FootprintsWithAConstantGapAreShiftedOntoTheTerrain) {
    for (const double gap : {-20.0, 20.0}) {
        const CityRead read = this->read({footprints([&](int) { return gap; }), hill()});
        expectOnGround(read);
        ASSERT_EQ(read.heights.bases.size(), 1U);
        EXPECT_EQ(read.heights.bases[0].rule, StandRule::shifted);
        EXPECT_EQ(read.heights.bases[0].buildings, 9U);
        EXPECT_NEAR(read.heights.bases[0].gapM, gap, 0.1);
        EXPECT_LT(read.heights.bases[0].spreadM, 0.2);
        EXPECT_TRUE(warns(read, "all were shifted"));
    }
}

TEST_F(StandingTest, TheUserMayKeepTheStatedElevations) {
    settings.stand = Stand::absolute;
    const CityRead read = this->read({footprints([](int) { return 20; }), hill()});
    expectOnGround(read, 20);
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::asStated);
    EXPECT_FALSE(read.heights.bases[0].fits());
    EXPECT_FALSE(warns(read, "shifted"));
}

TEST_F(StandingTest, BasesThatFitStayAsTheyAre) {
    const CityRead read = this->read({footprints([](int i) { return i % 2 * 0.4; }), hill()});
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::asStated);
    EXPECT_TRUE(read.heights.bases[0].fits());
    EXPECT_TRUE(read.warnings.empty());
    expectOnGround(read, 0.2, 0.26);
}

TEST_F(StandingTest, TheUserMaySetEachDown) {
    settings.stand = Stand::terrain;
    expectOnGround(read({footprints([](int i) { return i % 2 * 0.4; }), hill()}));
}

TEST_F(StandingTest, BasesThatDoNotFollowTheTerrainAreSetDownEach) {
    const CityRead read = this->read({footprints([](int i) { return i * 7 % 9 * 6; }), hill()});
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::setDown);
    EXPECT_TRUE(warns(read, "do not follow the terrain"));
    expectOnGround(read);
}

TEST_F(StandingTest, OneHouseFarOffIsSetDownByItself) {
    const CityRead read = this->read({footprints([](int i) { return i == 4 ? -30 : 0; }), hill()});
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::asStated);
    EXPECT_EQ(read.heights.bases[0].apart, 1U);
    EXPECT_TRUE(warns(read, "unlike the others"));
    expectOnGround(read);
}

TEST_F(StandingTest, CityJsonAtHeightZeroIsSetDownOnAHill) {
    CityJsonMaker maker;
    int number = 0;
    for (const glm::dvec2 low : corners())
        maker.addBuilding(
            fmt::format("house {}", number++),
            maker.boxSolid({low.x, low.y, -2}, {low.x + houseSideM, low.y + houseSideM, heightM - 2}));
    const auto city = folder.file("town.city.json", maker.document().dump());
    const LonLat middle = read({city}).city.frame.origin();
    const CityRead read = this->read({city, writeTerrain(folder.path("amsterdam.tif"), middle, steepSlope)});
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::setDown);
    EXPECT_NEAR(read.heights.bases[0].gapM, -100, 1);
    expectOnGround(read);
}

TEST_F(StandingTest, AMeshAtItsOwnZeroIsSetDownOnAHill) {
    const CityRead read = readObj(boxesObj([](glm::dvec2) { return 0; }), true);
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::setDown);
    expectOnGround(read);
}

TEST_F(StandingTest, AMeshWithElevationsThatFitStays) {
    const CityRead read = readObj(boxesObj([](glm::dvec2 low) { return steepSlope(low.x, low.y); }), true);
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::asStated);
    expectOnGround(read);
}

TEST_F(StandingTest, AMeshWithElevationsOfAnotherDatumIsShifted) {
    const CityRead read =
        readObj(boxesObj([](glm::dvec2 low) { return steepSlope(low.x, low.y) + 47; }), true);
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::shifted);
    expectOnGround(read);
}

// A mesh that counts from its highest base: by their height alone, the bases could be basements below a zero.
TEST_F(StandingTest, AMeshWhoseBasesFollowTheTerrainBelowItsZeroIsShifted) {
    const auto belowHighest = [](glm::dvec2 low) { return steepSlope(low.x, low.y) - steepSlope(50, 0); };
    const CityRead read = readObj(boxesObj(belowHighest), true);
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::shifted);
    EXPECT_EQ(read.heights.bases[0].aloft, 0U);
    expectOnGround(read);
    settings.stand = Stand::terrain;
    const CityRead setDown = readObj(boxesObj(belowHighest), true);
    EXPECT_EQ(setDown.heights.bases.at(0).aloft, 0U);
    expectOnGround(setDown);
}

TEST_F(StandingTest, BasesThatRangeOverMoreThanBasementsAreElevations) {
    const CityRead read = readObj(boxesObj([](glm::dvec2 low) { return (low.x - 50) / 3; }), false);
    ASSERT_NE(read.city.terrain, nullptr);
    EXPECT_EQ(read.city.terrain->source.method, TerrainMethod::fromBases);
    expectOnGround(read, 0, 1);
}

TEST_F(StandingTest, AMeshWithElevationsAndNoTerrainGetsOneFromItsBases) {
    const CityRead read = readObj(boxesObj([](glm::dvec2 low) { return steepSlope(low.x, low.y); }), false);
    ASSERT_NE(read.city.terrain, nullptr);
    EXPECT_EQ(read.city.terrain->source.method, TerrainMethod::fromBases);
    expectOnGround(read, 0, 0.3);
}

TEST_F(StandingTest, AMeshAtOneElevationStandsOnFlatGround) {
    const CityRead read = readObj(boxesObj([](glm::dvec2) { return 60; }), false);
    EXPECT_EQ(read.city.terrain, nullptr);
    EXPECT_TRUE(warns(read, "there is no terrain"));
    for (const auto& building : read.city.buildings) {
        EXPECT_NEAR(building->parts[0].bottomM, 0, 1e-3);
        EXPECT_NEAR(topM(*building), heightM, 1e-3);
        EXPECT_FALSE(building->parts[0].isOverhanging);
    }
}

// A footbridge 6 m above the zero of the mesh, between two houses.
TEST_F(StandingTest, ABridgeBetweenHousesStaysAboveTheGround) {
    for (const double zero : {0.0, 150.0})
        for (const bool withHill : {false, true}) {
            std::string text;
            int vertices = 0;
            for (const int column : {0, 1})
                addBox(text, vertices, fmt::format("house{}", column), {0, column * 30, zero},
                       {10, column * 30 + 10, zero + 12});
            addBox(text, vertices, "bridge", {3, 10, zero + 6}, {6, 30, zero + 9});
            const CityRead read = readObj(text, withHill);
            ASSERT_EQ(read.city.buildings.size(), 3U);
            const Part &house = read.city.buildings[0]->parts[0], &bridge = read.city.buildings[2]->parts[0];
            EXPECT_NEAR(bridge.bottomM - house.bottomM, 6, 1e-3) << zero << withHill;
            EXPECT_TRUE(bridge.isOverhanging) << zero << withHill;
            EXPECT_FALSE(house.isOverhanging) << zero << withHill;
            EXPECT_NEAR(house.bottomM, groundAt(read.city, {0.5, 5}), 0.1);
        }
}

// A gap of a sill is no gap, also of one building that counts from its own zero.
TEST_F(StandingTest, OneMeshWithASmallGapStandsAsStated) {
    std::string text;
    int vertices = 0;
    addBox(text, vertices, "house", {0, 0, 0.2}, {10, 10, 7});
    settings.upAxis = UpAxis::z;
    settings.meshAnchor = manhattan;
    const CityRead read =
        this->read({folder.file("house.obj", text), hill([](double, double) { return 0.0; })});
    EXPECT_EQ(read.heights.bases.at(0).rule, StandRule::asStated);
    EXPECT_FALSE(warns(read, "do not follow"));
}

TEST_F(StandingTest, ABasementStaysBelowTheZeroOfItsMesh) {
    std::string text;
    int vertices = 0;
    addBox(text, vertices, "office", {0, 0, -9}, {20, 20, 30});
    EXPECT_NEAR(topM(*readObj(text, false).city.buildings.at(0)), 30, 1e-3);
    const CityRead onHill = readObj(text, true);
    EXPECT_NEAR(topM(*onHill.city.buildings.at(0)) -
                    findLowestGround(*onHill.city.buildings[0], *onHill.city.terrain),
                30, 1e-3);
}

// Far from the origin the earth's surface drops by 0.27 m at 2 km: it must be subtracted once.
TEST_F(StandingTest, AnImportedCityStandsWhereItStoodBefore) {
    std::string features = feature(sizedRectangle(0, 0, 10, 10), R"("height":12)");
    features += "," + feature(sizedRectangle(2000, 0, 10, 10), R"("height":12)");
    features += "," + feature(sizedRectangle(50, 0, 10, 10), R"("height":12)");
    const auto houses =
        folder.file("houses.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
    const CityRead first = read({houses, hill()});
    ASSERT_TRUE(writeCityGeoPackage(folder.path("city.gpkg"), first.city));
    settings.frame = first.city.frame;
    const CityRead again = read({folder.path("city.gpkg"), folder.path("hill.tif")});
    ASSERT_EQ(again.city.buildings.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(again.city.buildings[i]->parts[0].bottomM, first.city.buildings[i]->parts[0].bottomM,
                    0.02);
        EXPECT_NEAR(topM(*again.city.buildings[i]), topM(*first.city.buildings[i]), 0.02);
    }
}

TEST_F(StandingTest, SaysWhatWasFoundAndDone) {
    BaseFit fit{.file = "town.obj", .buildings = 1200, .gapM = -20.04, .spreadM = 0.12};
    fit.rule = StandRule::shifted;
    EXPECT_EQ(describe(fit),
              "Bases of town.obj lie 20 m below the terrain (median of 1,200, spread 0.1 m); all were "
              "shifted onto it");
}

}  // namespace
}  // namespace noonmark::tests
