#include "core/io/terrain/ground_choice.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/io/read_city.h"
#include "tests/core/io/city_reading.h"
#include "tests/core/io/footprint_files.h"
#include "tests/core/io/terrain_files.h"

namespace noonmark::tests {
namespace {

// A row of two houses and one alone, 8, 11 and 15 m high, on ground that rises by 1 in 10 to the east.
struct House {
    Ring outline;
    double heightM;
};
std::vector<House> houses() {
    return {{sizedRectangle(-60, 0, 12, 20), 8},
            {sizedRectangle(-48, 0, 12, 20), 11},
            {sizedRectangle(20, -40, 25, 16), 15}};
}

double ground(double x, double /*y*/) { return 50 + x / 10; }

// Roofs are level, at their height above the ground at the middle of the building.
double surface(double x, double y) {
    for (const House& house : houses()) {
        const Box2 box = bounds(house.outline);
        if (contains({house.outline, {}}, {x, y}))
            return ground(double(box.low.x + box.high.x) / 2, 0) + house.heightM;
    }
    return ground(x, y);
}

class SurfaceModel : public tests::CityReading {
protected:
    std::filesystem::path outlines(bool withHeights = true) {
        std::string features;
        for (const House& house : houses())
            features +=
                (features.empty() ? "" : ",") +
                feature(house.outline, withHeights ? fmt::format(R"("height":{})", house.heightM) : "");
        return folder.file("houses.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
    }
    std::filesystem::path dsm() { return writeTerrain(folder.path("dsm.tif"), manhattan, surface); }
    std::filesystem::path dtm() { return writeTerrain(folder.path("dtm.tif"), manhattan, ground); }
    static bool warns(const CityRead& read, std::string_view what) {
        return std::ranges::any_of(
            read.warnings, [&](const Warning& one) { return one.what.find(what) != std::string::npos; });
    }
    static double elevation(const City& city, float z) { return city.frame.originElevationM() + double(z); }

    void expectSameGround(const CityRead& one, const CityRead& other, double toleranceM) {
        ASSERT_EQ(one.city.buildings.size(), other.city.buildings.size());
        for (std::size_t i = 0; i < one.city.buildings.size(); ++i) {
            EXPECT_NEAR(elevation(one.city, one.city.buildings[i]->parts[0].bottomM),
                        elevation(other.city, other.city.buildings[i]->parts[0].bottomM), toleranceM);
            EXPECT_NEAR(elevation(one.city, topM(*one.city.buildings[i])),
                        elevation(other.city, topM(*other.city.buildings[i])), toleranceM);
        }
        for (double y = -150; y <= 150; y += 5)
            for (double x = -150; x <= 150; x += 5)
                EXPECT_NEAR(elevation(one.city, groundAt(one.city, {x, y})),
                            elevation(other.city, groundAt(other.city, {x, y})), toleranceM)
                    << x << ' ' << y;
    }

    TemporaryFolder folder;
};

TEST_F(SurfaceModel, TheGroundAroundTheOutlinesReplacesItsRoofs) {
    const CityRead onSurface = read({outlines(), dsm()}), onGround = read({outlines(), dtm()});
    EXPECT_TRUE(warns(onSurface, "steps at the outlines"));
    EXPECT_GT(onSurface.city.terrain->source.underBuildings, 800U);
    EXPECT_FALSE(warns(onGround, "steps"));
    EXPECT_EQ(onGround.city.terrain->source.underBuildings, 0U);
    expectSameGround(onSurface, onGround, 0.7);  // interpolated under a house on a slope
}

// Crowns 8 m wide and 10 m high, 20 m apart, between and over the houses.
double surfaceWithTrees(double x, double y) {
    const double east = std::remainder(x, 20), north = std::remainder(y, 20);
    return std::hypot(east, north) < 4 ? std::max(surface(x, y), ground(x, y) + 10) : surface(x, y);
}

TEST_F(SurfaceModel, TreesAreNoGround) {
    const auto model = writeTerrain(folder.path("trees.tif"), manhattan, surfaceWithTrees);
    expectSameGround(read({outlines(), model}), read({outlines(), dtm()}), 0.8);
}

TEST_F(SurfaceModel, TheUserMayUseItUnchanged) {
    settings.terrainShows = TerrainShows::ground;
    const CityRead read = this->read({outlines(), dsm()});
    EXPECT_EQ(read.city.terrain->source.underBuildings, 0U);
    const glm::dvec2 roof = read.city.frame.localFromLonLat(Frame(manhattan).lonLatFromLocal({32, -32}));
    EXPECT_NEAR(elevation(read.city, groundAt(read.city, roof)), surface(32, -32), 0.1);
}

TEST_F(SurfaceModel, BesideATerrainItIsNotTheGround) {
    const CityRead expected = read({outlines(), dtm()});
    for (const auto& files : {std::vector{outlines(), dsm(), dtm()}, {dtm(), dsm(), outlines()}}) {
        const CityRead read = this->read(files);
        EXPECT_EQ(read.city.terrain->source.file, "dtm.tif");
        EXPECT_TRUE(warns(read, "the other terrain is the ground"));
        expectSameGround(read, expected, 0.02);
    }
}

// Houses on a steep slope, as in a village in the Alps.
TEST_F(SurfaceModel, ASlopeIsNone) {
    const auto steep = [](double x, double y) { return 500 + 0.5 * x + 0.3 * y; };
    const CityRead read = this->read({outlines(), writeTerrain(folder.path("alp.tif"), manhattan, steep)});
    EXPECT_FALSE(warns(read, "steps"));
    EXPECT_EQ(read.city.terrain->source.underBuildings, 0U);
}

TEST_F(SurfaceModel, GivesHeightsToHousesWithoutAny) {
    EXPECT_TRUE(warns(read({outlines(false), dsm()}), "--heights-from-surface"));
    settings.heightsFromSurface = true;
    for (const auto& files : {std::vector{outlines(false), dsm(), dtm()}, {outlines(false), dsm()}}) {
        const CityRead read = this->read(files);
        EXPECT_FALSE(warns(read, "no height in the data")) << "they have one now";
        EXPECT_FALSE(warns(read, "no field of heights"));
        for (std::size_t i = 0; i < 3; ++i) {
            const Part& part = read.city.buildings.at(i)->parts[0];
            const Box2 box = bounds(houses()[i].outline);
            const double roof =
                surface(double(box.low.x + box.high.x) / 2, double(box.low.y + box.high.y) / 2);
            EXPECT_NEAR(elevation(read.city, part.topM), roof, 0.5);
            EXPECT_EQ(part.heightSource, HeightSource::measured);
        }
    }
}

}  // namespace
}  // namespace noonmark::tests
