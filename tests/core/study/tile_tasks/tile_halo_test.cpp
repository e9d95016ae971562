#include "core/study/tile_tasks/plan/tile_load.h"

#include <gtest/gtest.h>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

constexpr float towerM = 100;

/// One step of the sun in the south at 45 degrees: shadows fall due north and are as long as what casts them.
SunSteps southernSun() {
    SunSteps sun;
    sun.steps.push_back(
        {.direction = {0, -std::sqrt(0.5F), std::sqrt(0.5F)}, .azimuthDeg = 180, .altitudeDeg = 45});
    return sun;
}

/// The halo of a tile of 100 m around the origin, in a city of one tower with its north wall at y.
TileHalo haloWithTowerAt(float northWallM, double cellM = 10) {
    const City city = cityOf({{{-5, northWallM - 10, 0}, {5, northWallM, towerM}}});
    OccluderSurvey survey({{-500, -500}, {500, 500}}, cellM);
    survey.add(city, {{-500, -500}, {500, 500}});
    return findHalo(survey, ShadowReach(southernSun()), {-50, -50, 1, 100, 100});
}

TEST(TileHalo, ContainsATowerJustInsideItsReachAndNotOneJustOutside) {
    const TileHalo inside = haloWithTowerAt(-50 - towerM + 1);
    EXPECT_LE(inside.occluders.low.y, -50 - towerM + 1);
    EXPECT_EQ(inside.occluders.high.y, 50);
    EXPECT_EQ(inside.buildings, 1U);
    // Coarse cells of 10 m, a metre of margin and the width of a degree: 20 m are outside for certain.
    const TileHalo outside = haloWithTowerAt(-50 - towerM - 20);
    EXPECT_EQ(outside.occluders.low.y, -50);
    EXPECT_EQ(outside.occluders.high.y, 50);
}

TEST(TileHalo, DoesNotReachTowardsTheSideFromWhichNoShadowFalls) {
    EXPECT_EQ(haloWithTowerAt(50 + 15 + 10).occluders.high.y, 50);
}

TEST(TileHalo, ReadsAllOfABuildingThatTouchesIt) {
    const City city = cityOf({{{-5, -190, 0}, {5, -140, towerM}}});
    OccluderSurvey survey({{-500, -500}, {500, 500}}, 10);
    survey.add(city, {{-500, -500}, {500, 500}});
    const TileHalo halo = findHalo(survey, ShadowReach(southernSun()), {-50, -50, 1, 100, 100});
    EXPECT_LE(halo.reads.low.y, -190);
}

TEST(TileHalo, IsNeverSmallerThanTheEnginesReach) {
    const City city = cityOf(randomBoxes(5, 40));
    const Box2 all = bounds(city);
    OccluderSurvey survey({all.low - 10.0F, all.high + 10.0F}, 25);
    survey.add(city, {all.low - 10.0F, all.high + 10.0F});
    const SunSteps sun = southernSun();
    const ShadowReach reach(sun);
    const Grid tile{double(all.low.x), double(all.low.y), 1, 40, 40};
    const TileHalo halo = findHalo(survey, reach, tile);
    const Box2 box{{float(tile.westM), float(tile.southM)}, {float(tile.eastM()), float(tile.northM())}};
    for (const auto& building : city.buildings) {
        const Box2 own = bounds(*building);
        if (!reach.touches(own, topM(*building), box)) continue;
        EXPECT_GE(own.low.x, halo.reads.low.x);
        EXPECT_GE(own.low.y, halo.reads.low.y);
        EXPECT_LE(own.high.x, halo.reads.high.x);
        EXPECT_LE(own.high.y, halo.reads.high.y);
    }
}

TEST(OccluderSurvey, CountsABuildingOnceHoweverOftenItIsRead) {
    const City city = cityOf({{{-5, -5, 0}, {5, 5, 10}}});
    OccluderSurvey once({{-100, -100}, {100, 100}}, 10), twice = once;
    once.add(city, {{-100, -100}, {100, 100}});
    twice.add(city, {{-100, -100}, {0, 100}});
    twice.add(city, {{0, -100}, {100, 100}});
    std::size_t buildings = 0;
    for (std::size_t i = 0; i < once.cells().size(); ++i) {
        EXPECT_EQ(once.cells()[i].hashSum, twice.cells()[i].hashSum);
        EXPECT_EQ(once.cells()[i].highestM, twice.cells()[i].highestM);
        buildings += twice.cells()[i].buildings;
    }
    EXPECT_EQ(buildings, 1U);
    EXPECT_EQ(twice.buildingsBox(), bounds(city));
}

}  // namespace
}  // namespace noonmark
