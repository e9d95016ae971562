#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/engines/horizon/attribution/horizon_breakdown.h"
#include "core/geo/frame.h"
#include "tests/core/engines/sweep_scenes.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark::tests {
namespace {

double toTangent(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

Errors errorsAgainstRays(const City& city, const Receivers& receivers, double binDeg = 0.2) {
    const SunSteps sun = threeDays();
    return errorsOf(swept(city, receivers, sun, binDeg), traced(city, receivers, sun), receivers);
}

std::vector<Sun> rising(double azimuthDeg) {
    std::vector<Sun> suns;
    for (int i = 0; i < 160; ++i) suns.push_back({azimuthDeg, 0.63 + 0.5 * i});
    return suns;
}

double hiddenBelow(const std::vector<Sun>& suns, double tan) {
    return double(
        std::ranges::count_if(suns, [&](const Sun& sun) { return toTangent(sun.altitudeDeg) < tan; }));
}

// A ridge 40 m high along x = -5 hides from the valley to its west a sun in the east below a slope of 40 /
// distance.
TEST(HorizonTerrain, ARidgeShadesTheValleyBehindIt) {
    const City city =
        groundOf(80, [](glm::dvec2 place) { return std::max(0.0, 40 - 2 * std::abs(place.x + 5)); });
    const Receivers receivers = receiversOver(city, -300, -20, -30, 20);
    const std::vector<Sun> suns = rising(90);
    const ShadowField field = swept(city, receivers, oneDay(suns));
    for (const std::uint32_t cell : receivers.cells) {
        const double tan = 40 / (-5 - double(receivers.position(cell).x));
        EXPECT_NEAR(double(field.grossMin[cell]), hiddenBelow(suns, tan), 1.001) << cell;
        EXPECT_EQ(field.continuousMin[cell], field.grossMin[cell]) << cell;
    }
}

// Ground rising to the north at 30 degrees: a receiver's own ground hides a sun in the north below that
// altitude.
TEST(HorizonTerrain, ASlopeHidesTheSunBehindItself) {
    const double slope = toTangent(30);
    const City city = groundOf(40, [&](glm::dvec2 place) { return place.y * slope; });
    const Receivers receivers = receiversOver(city, -60, -60, 60, 60, 2.5);
    const std::vector<Sun> behind = rising(0), before = rising(180);
    const ShadowField dark = swept(city, receivers, oneDay(behind)),
                      lit = swept(city, receivers, oneDay(before));
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_NEAR(double(dark.grossMin[cell]), hiddenBelow(behind, slope), 1.001) << cell;
        EXPECT_EQ(lit.grossMin[cell], 0) << cell;
    }
}

// Ground falls to the north by 1 in 5, with a wall of 10 m at y = 0: behind the wall the sun is hidden below
// a slope of (10 + 0.2 y) / y.
TEST(HorizonTerrain, ATowerShadesFartherDownASlope) {
    City city = groundOf(60, [](glm::dvec2 place) { return -0.2 * place.y; });
    city.buildings.push_back(buildingOf({rectangle(-150, -2, 150, 0), {}}, -5, 10));
    const Receivers receivers = receiversOver(city, -5, 0, 5, 200);
    const std::vector<Sun> suns = rising(180);
    const ShadowField field = swept(city, receivers, oneDay(suns));
    for (const std::uint32_t cell : receivers.cells) {
        const double y = double(receivers.position(cell).y);
        EXPECT_NEAR(double(field.grossMin[cell]), hiddenBelow(suns, (10 + 0.2 * y) / y), 1.001) << y;
    }
}

TEST(HorizonTerrain, RoughHillsAgreeWithRays) {
    for (const double cellM : {1.0, 3.7, 12.0}) {
        City city;
        city.terrain = terrainOf(int(160 / cellM), cellM, RandomHills(7));
        const Receivers receivers = receiversOver(city, -40.3F, -40.3F, 40.7F, 40.7F, 2);
        const Errors errors = errorsAgainstRays(city, receivers);
        EXPECT_LE(errors.mean, 0.1) << cellM;
        EXPECT_LE(errors.max, 5) << cellM;
    }
}

// Posts like the rows and columns of a projected map: rotated from north, with cells that are not square, and
// bent.
TEST(HorizonTerrain, HillsOnATurnedAndBentGridAgreeWithRays) {
    PostGrid posts(-80, -80, 2, 80, 80);
    posts.columnStep = {1.9, 0.35};
    posts.rowStep = {-0.6, 2.2};
    posts.first = -39.5 * (posts.columnStep + posts.rowStep);
    posts.cellM = 2.1;
    for (const bool bent : {false, true}) {
        if (bent)
            posts.bend = {
                glm::dvec2{0.8, -0.5}, {0.4, 0.6}, {-0.7, 0.3}, {0.1, 0}, {0, 0.2}, {0, 0}, {0.1, 0}};
        Terrain terrain{posts, {}};
        RandomHills hills(5);
        for (int row = 0; row < posts.rows; ++row)
            for (int column = 0; column < posts.columns; ++column)
                terrain.elevationM.push_back(float(hills(posts.centre(column, row))));
        City city;
        city.terrain = std::make_shared<const Terrain>(std::move(terrain));
        const Receivers receivers = receiversOver(city, -40.3F, -40.3F, 40.7F, 40.7F, 2);
        const Errors errors = errorsAgainstRays(city, receivers);
        EXPECT_LE(errors.mean, 0.1) << bent;
        EXPECT_LE(errors.max, 5) << bent;
    }
}

// Receivers on the terrain's own points, and suns in line with its edges.
TEST(HorizonTerrain, ReceiversOnTheTerrainsPointsAgreeWithRays) {
    City city;
    city.terrain = terrainOf(120, 1, RandomHills(3));
    const Receivers receivers = receiversOver(city, -40, -40, 40, 40);
    ASSERT_EQ(receivers.grid.centre(0, 0), city.terrain->grid.centre(20, 20));
    SunSteps sun;
    for (const double azimuth : {0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0})
        addDay(sun, rising(azimuth));
    const Errors errors = errorsOf(swept(city, receivers, sun, 0.1), traced(city, receivers, sun), receivers);
    EXPECT_LE(errors.mean, 0.05);
}

TEST(HorizonTerrain, RandomBuildingsOnRandomHillsAgreeWithRays) {
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
        City city;
        city.terrain = terrainOf(100, 5, RandomHills(seed));
        addStandingBoxes(city, seed, 6, -60);
        const Receivers receivers = receiversOver(city, -60.3F, -60.3F, 60.7F, 60.7F, 2);
        const Errors errors = errorsAgainstRays(city, receivers);
        EXPECT_LE(errors.mean, 0.1) << seed;
        EXPECT_LE(errors.meanContinuous, 0.3) << seed;
    }
}

TEST(HorizonTerrain, LevelTerrainIsFlatGround) {
    City flat = cityOf({{{0, 0, 0}, {40, 20, 30}}, {{60, 10, 0}, {80, 60, 55}}});
    City level = flat;
    level.terrain = terrainOf(60, 10, [](glm::dvec2) { return 0.0; });
    const Receivers onFlat = receiversOver(flat, -60, -60, 100, 100),
                    onLevel = receiversOver(level, -60, -60, 100, 100);
    const ShadowField a = swept(flat, onFlat, threeDays()), b = swept(level, onLevel, threeDays());
    double off = 0;
    for (const std::uint32_t cell : onFlat.cells)
        off += std::abs(double(a.grossMin[cell] - b.grossMin[cell]));
    EXPECT_LE(off / double(onFlat.cells.size()), 0.001 * a.sunlitMinutesPerDay);  // a millimetre of height
}

// A range 300 m high, 40 km to the south: the earth's curvature hides 109 m of it.
TEST(HorizonTerrain, AFarRangeIsSeenBeyondTheEarthsCurvature) {
    City city;
    city.terrain = terrainOf(121, 1000, [](glm::dvec2 place) {
        return (std::abs(place.y + 40000) < 500 ? 300 : 0) - earthDropM(place);
    });
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20, 2);
    std::vector<Sun> suns;
    for (int i = 0; i < 60; ++i) suns.push_back({180, 0.101 + 0.01 * i});
    const SunSteps sun = oneDay(suns);
    const ShadowField field = swept(city, receivers, sun), truth = traced(city, receivers, sun);
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_NEAR(double(field.grossMin[cell]), hiddenBelow(suns, (300 - 109.25) / 40000), 1.001);
        EXPECT_NEAR(field.grossMin[cell], truth.grossMin[cell], 1.001);
    }
}

TEST(HorizonTerrain, ATerrainOfOneRowHasNoSurface) {
    City city;
    city.terrain = std::make_shared<const Terrain>(Terrain{{-50, -5, 10, 10, 1}, std::vector<float>(10, 3)});
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20);
    const ShadowField field = swept(city, receivers, oneDay(arc(30, 40)));
    for (const std::uint32_t cell : receivers.cells) ASSERT_EQ(field.grossMin[cell], 0);
}

// A hill in the east and a wall in the south: it is known which of them shades when, and the attributed
// shadows add up.
TEST(HorizonTerrain, TheTerrainHasAShareOfItsOwn) {
    City city =
        groundOf(80, [](glm::dvec2 place) { return std::max(0.0, 60 - 2 * std::abs(place.x - 205)); });
    city.buildings.push_back(buildingOf({rectangle(-300, -12, 100, 0), {}}, 0, 20));
    const Receivers receivers = receiversOver(city, -20, 2, 20, 30);
    SunSteps sun;
    addDay(sun, rising(90));
    addDay(sun, rising(180));
    NoProgress progress;
    const ShadowBreakdown shares =
        computeHorizonBreakdown(city, receivers, sun, makeOneSet(sun), {.byBuilding = true}, progress, {})
            .value();
    const ShadowField both = swept(city, receivers, sun, 0.5);
    SunSteps east, south;
    addDay(east, rising(90));
    addDay(south, rising(180));
    const auto minutesOf = [&](const SunSteps& steps) {
        const ShadowField field = swept(city, receivers, steps, 0.5);
        double sum = 0;
        for (const std::uint32_t cell : receivers.cells) sum += double(field.grossMin[cell]);
        return sum;
    };
    ASSERT_TRUE(shares.terrain);
    ASSERT_EQ(shares.buildings.size(), 1);
    EXPECT_DOUBLE_EQ(shares.terrain->attributedMinM2[0], minutesOf(east));
    EXPECT_DOUBLE_EQ(shares.terrain->soleMinM2[0], minutesOf(east));
    EXPECT_DOUBLE_EQ(shares.buildings[0].attributedMinM2[0], minutesOf(south));
}

}  // namespace
}  // namespace noonmark::tests
