#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/receivers/roof_receivers.h"
#include "tests/core/engines/sweep_scenes.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark::tests {
namespace {

Receivers placeReceiversAt(ReceiverPlaces places, const City& city, float west, float south, float east,
                           float north, double cellM = 1) {
    return placeReceivers(city, makeRegionFromLocalBox({{west, south}, {east, north}}), {cellM, places})
        .value();
}

void expectAgreement(const City& city, const Receivers& receivers, double maxGross, double maxContinuous) {
    const SunSteps sun = threeDays();
    const Errors errors = errorsOf(swept(city, receivers, sun), traced(city, receivers, sun), receivers);
    EXPECT_LE(errors.mean, maxGross);
    EXPECT_LE(errors.meanContinuous, maxContinuous);
}

/// Gabled houses in rows, some rotated, some with a lower wing attached.
City gabledQuarter(std::uint32_t seed, int perSide) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return float(std::uniform_real_distribution<double>(low, high)(random));
    };
    City city;
    for (int row = 0; row < perSide; ++row)
        for (int column = 0; column < perSide; ++column) {
            const float west = float(column) * 24 + between(0, 3), south = float(row) * 24 + between(0, 3),
                        east = west + between(7, 14), north = south + between(7, 14), eaves = between(3, 12);
            city.buildings.push_back(gabledHouse(west, south, east, north, eaves, eaves + between(1, 7)));
            if (random() % 2 == 0)
                city.buildings.push_back(gabledHouse(east, south, east + between(2, 5), north - 1, 3, 4.5F));
        }
    return city;
}

TEST(HorizonRoofs, GabledHousesAgreeWithRays) {
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
        const City city = gabledQuarter(seed, 5);
        expectAgreement(city, receiversOver(city, -40.3F, -40.3F, 150.7F, 150.7F), 0.1, 0.3);
    }
}

TEST(HorizonRoofs, AGableThrowsItsOwnShadow) {
    // The ridge, 14 m high, runs north at x = 6; the sun is in the east.
    City city;
    city.buildings.push_back(gabledHouse(0, 0, 12, 18, 8, 14));
    const Receivers receivers = receiversOver(city, -80, 4, -1, 14);
    std::vector<Sun> suns;
    for (int i = 0; i < 160; ++i) suns.push_back({90, 0.63 + 0.5 * i});
    const ShadowField field = swept(city, receivers, oneDay(suns));
    for (const std::uint32_t cell : receivers.cells) {
        const double x = double(receivers.position(cell).x);
        const double tan = std::max(14 / (6 - x), 8 / -x);
        const auto hidden = std::ranges::count_if(
            suns, [&](const Sun& sun) { return std::tan(sun.altitudeDeg * std::numbers::pi / 180) < tan; });
        EXPECT_NEAR(double(field.grossMin[cell]), double(hidden), 1.001) << x;
    }
}

TEST(HorizonRoofs, ManyThousandsOfRoofsAreSwept) {
    const City city = gabledQuarter(3, 55);
    std::size_t triangles = 0;
    for (const auto& building : city.buildings) triangles += building->parts[0].mesh->triangles.size();
    ASSERT_GT(triangles, 50'000);
    const Receivers receivers = receiversOver(city, 400.3F, 400.3F, 460.7F, 460.7F, 2);
    SunSteps sun;
    addDay(sun, arc(120, 30));
    const Errors errors = errorsOf(swept(city, receivers, sun), traced(city, receivers, sun), receivers);
    EXPECT_LE(errors.mean, 0.15);
}

// A roof at 12 m west of a 60 m tower: the sun in the east is hidden below a slope of 48 / distance.
TEST(HorizonRoofs, ARoofBesideAHigherTower) {
    const City city = cityOf({{{-60, -40, 0}, {0, 40, 12}}, {{0, -300, 0}, {20, 300, 60}}});
    const Receivers receivers = placeReceiversAt(ReceiverPlaces::roofs, city, -60, -20, 0, 20);
    std::vector<Sun> suns;
    for (int i = 0; i < 170; ++i) suns.push_back({90, 0.63 + 0.5 * i});
    const SunSteps sun = oneDay(suns);
    const ShadowField field = swept(city, receivers, sun), truth = traced(city, receivers, sun);
    ASSERT_EQ(receivers.cells.size(), 60 * 40);
    for (const std::uint32_t cell : receivers.cells) {
        ASSERT_EQ(receivers.position(cell).z, 12);
        const double tan = 48 / -double(receivers.position(cell).x);
        const auto hidden = std::ranges::count_if(
            suns, [&](const Sun& step) { return std::tan(step.altitudeDeg * std::numbers::pi / 180) < tan; });
        EXPECT_NEAR(double(field.grossMin[cell]), double(hidden), 1.001) << cell;
        EXPECT_NEAR(field.grossMin[cell], truth.grossMin[cell], 1.001) << cell;
    }
}

TEST(HorizonRoofs, RoofsAndGroundOfARandomQuarterAgreeWithRays) {
    City city = gabledQuarter(5, 4);
    for (const Box3& box : randomBoxes(5, 4))
        city.buildings.push_back(
            buildingOf({box.low + glm::dvec3(-100, 0, -box.low.z), box.high + glm::dvec3(-100, 0, 0)}));
    city.buildings.push_back(buildingOf({{-90, 20, 14}, {-40, 50, 17}}));  // a deck above roofs and streets
    for (const ReceiverPlaces places : {ReceiverPlaces::roofs, ReceiverPlaces::both})
        expectAgreement(city, placeReceiversAt(places, city, -110.3F, -10.3F, 100.7F, 100.7F), 0.1, 0.35);
}

TEST(HorizonRoofs, RoofsOnHillsAgreeWithRays) {
    City city;
    city.terrain = terrainOf(60, 6, RandomHills(11));
    addStandingBoxes(city, 11, 5, -50);
    expectAgreement(city, placeReceiversAt(ReceiverPlaces::both, city, -70.3F, -70.3F, 70.7F, 70.7F), 0.1,
                    0.3);
}

}  // namespace
}  // namespace noonmark::tests
