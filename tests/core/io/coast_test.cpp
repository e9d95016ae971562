#include "core/io/context/read_context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace noonmark {
namespace {

const Box2 coastBox{{-1000, -1000}, {1000, 1000}};
constexpr double coastBoxM2 = 2000.0 * 2000;

double seaAreaOf(const Sea& sea) {
    double sum = 0;
    for (const Footprint& polygon : sea.polygons) sum += area(polygon);
    return sum;
}

bool liesInSea(const Sea& sea, glm::dvec2 point) {
    return std::ranges::any_of(sea.polygons,
                               [&](const Footprint& polygon) { return contains(polygon, point); });
}

CoastLine turnedRound(CoastLine line) {
    std::ranges::reverse(line);
    return line;
}

// Counter-clockwise, land inside.
CoastLine islandAt(double x, double y) {
    return {{x, y}, {x + 200, y}, {x + 200, y + 200}, {x, y + 200}, {x, y}};
}

TEST(Coast, TheSeaLiesOnTheRight) {
    const CoastLine eastwards{{-1500, 0}, {1500, 0}};
    const Sea south = findSea({eastwards}, coastBox), north = findSea({turnedRound(eastwards)}, coastBox);
    EXPECT_NEAR(seaAreaOf(south), coastBoxM2 / 2, 1);
    EXPECT_TRUE(liesInSea(south, {0, -500}));
    EXPECT_FALSE(liesInSea(south, {0, 500}));
    EXPECT_TRUE(liesInSea(north, {0, 500}));
    EXPECT_TRUE(south.continuedM.empty());
    EXPECT_TRUE(south.openEnds.empty());
}

TEST(Coast, WaysAreChainedWhateverTheirOrder) {
    const Sea sea = findSea(
        {{{300, 50}, {1500, 0}}, {{-1500, 0}, {-300, 20}}, {{-300, 20}, {0, -80}, {300, 50}}}, coastBox);
    EXPECT_TRUE(sea.openEnds.empty());
    EXPECT_EQ(sea.polygons.size(), 1U);
    EXPECT_TRUE(liesInSea(sea, {0, -100}));
    EXPECT_FALSE(liesInSea(sea, {0, -60}));
}

TEST(Coast, AnIslandIsLandInTheSea) {
    const Sea sea = findSea({islandAt(0, 0)}, coastBox);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2 - 200 * 200, 1);
    EXPECT_FALSE(liesInSea(sea, {100, 100}));
    EXPECT_TRUE(liesInSea(sea, {-500, 0}));
    const Sea lagoon = findSea({turnedRound(islandAt(0, 0))}, coastBox);
    EXPECT_NEAR(seaAreaOf(lagoon), 200 * 200, 1) << "the sea inside a ring of land";
}

TEST(Coast, ABayReachesIntoTheLand) {
    const CoastLine bay{{-1500, 0}, {-200, 0}, {-200, 600}, {200, 600}, {200, 0}, {1500, 0}};
    const Sea sea = findSea({bay, islandAt(-100, 100)}, coastBox);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2 / 2 + 400 * 600 - 200 * 200, 1);
    EXPECT_TRUE(liesInSea(sea, {150, 500}));
    EXPECT_FALSE(liesInSea(sea, {0, 200})) << "the island in the bay";
    EXPECT_FALSE(liesInSea(sea, {500, 500}));
}

TEST(Coast, ABrokenCoastGivesNoSeaAndIsCounted) {
    const Sea sea = findSea({{{-1500, 0}, {0, 0}}}, coastBox);
    EXPECT_TRUE(sea.polygons.empty());
    ASSERT_EQ(sea.openEnds.size(), 1U);
    EXPECT_EQ(sea.openEnds[0], glm::dvec2(0, 0));
    const Sea withIsland = findSea({{{-1500, 0}, {0, 0}}, islandAt(300, 300)}, coastBox);
    EXPECT_TRUE(withIsland.polygons.empty()) << "what lies around the island is not known";
}

TEST(Coast, WhatLiesApartFromABrokenCoastIsKnown) {
    const Sea sea = findSea({{{-1500, 0}, {1500, 0}}, {{-1500, 500}, {0, 500}}}, coastBox);
    EXPECT_EQ(sea.openEnds.size(), 1U);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2 / 2, 1);
}

TEST(Coast, ACoastMayRunAlongTheEdge) {
    const Sea land = findSea({{{-1500, -1000}, {-500, -1000}, {1500, -1000}}}, coastBox);
    EXPECT_TRUE(land.polygons.empty()) << "the sea begins where the box ends";
    const Sea sea = findSea({{{1500, -1000}, {500, -1000}, {-1500, -1000}}}, coastBox);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2, 1);
}

TEST(Coast, GoesOnStraightToANearEdgeAndSaysHowFar) {
    const Sea sea = findSea({{{-940, 0}, {850, 0}}}, coastBox);
    EXPECT_NEAR(seaAreaOf(sea), coastBoxM2 / 2, 1);
    EXPECT_THAT(sea.continuedM, testing::UnorderedElementsAre(60, 150));
}

TEST(Coast, CoastsThatMeetHeadOnAreNotTakenForOne) {
    const Sea sea = findSea({{{-1500, 0}, {0, 0}}, {{1500, 0}, {0, 0}}}, coastBox);
    EXPECT_TRUE(sea.polygons.empty());
    EXPECT_EQ(sea.openEnds.size(), 1U);
    EXPECT_EQ(sea.contradictions, 2U) << "one on either side";
}

TEST(Coast, WithoutCoastThereIsNoSea) { EXPECT_TRUE(findSea({}, coastBox).polygons.empty()); }

}  // namespace
}  // namespace noonmark
