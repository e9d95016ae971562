#include "core/receivers/points/glazing_receivers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/receivers/points/point_list.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::ElementsAre;
using testing::HasSubstr;

// A house of 10 x 10 m and 9 m, with a balcony of 1 m before its southern wall from 3 to 3.2 m.
City houseWithBalcony() { return cityOf({{{0, 0, 0}, {10, 10, 9}}, {{0, -1, 3}, {10, 0, 3.2}}}); }
const Region everywhere = makeRegionFromLocalBox({{-100, -100}, {100, 100}});

GlazingPlaced placed(const City& city, const std::vector<GlazingShape>& windows) {
    return placeGlazing(city, everywhere, windows, {});
}

std::vector<std::string> reasons(const GlazingPlaced& windows) {
    std::vector<std::string> all;
    for (const Warning& warning : windows.warnings) all.push_back(warning.what);
    return all;
}

TEST(GlazingReceivers, APaneFacesAwayFromTheBuildingHoweverItWasDrawn) {
    // 2 m wide from 4 to 5 m, in the southern wall.
    std::vector<glm::dvec3> ring{{4, 0, 4}, {6, 0, 4}, {6, 0, 5}, {4, 0, 5}};
    for (int turn = 0; turn < 2; ++turn) {
        const GlazingPlaced windows = placed(houseWithBalcony(), {{"a", ring, {}, {}}});
        ASSERT_EQ(windows.receivers.size(), 1U);
        EXPECT_EQ(windows.receivers.points.positions[0], glm::vec3(5, 0, 4.5));
        EXPECT_NEAR(windows.receivers.points.normals[0].y, -1, 1e-6);
        EXPECT_EQ(windows.receivers.elements[0].building, 0U);
        EXPECT_EQ(windows.receivers.elements[0].floor, 1);
        EXPECT_TRUE(windows.warnings.empty());
        std::ranges::reverse(ring);
    }
}

TEST(GlazingReceivers, TheMiddleOfAPaneIsThatOfItsArea) {
    // An L: 2 x 1 m and 1 x 1 m above it; the centre of area is (5 / 6, 5 / 6) from its corner.
    const std::vector<glm::dvec3> ring{{4, 0, 4}, {6, 0, 4}, {6, 0, 5}, {5, 0, 5}, {5, 0, 6}, {4, 0, 6}};
    const GlazingPlaced windows = placed(houseWithBalcony(), {{"a", ring, {}, {}}});
    ASSERT_EQ(windows.receivers.size(), 1U);
    EXPECT_NEAR(windows.receivers.points.positions[0].x, 4 + 5.0 / 6, 1e-5);
    EXPECT_NEAR(windows.receivers.points.positions[0].z, 4 + 5.0 / 6, 1e-5);
}

TEST(GlazingReceivers, APointTakesTheNearestWall) {
    const GlazingPlaced windows =
        placed(houseWithBalcony(), {{"on", {{10, 5, 7}}, {}, 7}, {"off", {{10.4, 5, 7}}, {}, {}}});
    ASSERT_EQ(windows.receivers.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(windows.receivers.points.positions[i], glm::vec3(10, 5, 7));
        EXPECT_NEAR(windows.receivers.points.normals[i].x, 1, 1e-6);
    }
    EXPECT_EQ(windows.receivers.elements[0].floor, 7);
    EXPECT_EQ(windows.receivers.elements[1].floor, 2);
    EXPECT_THAT(reasons(windows), ElementsAre(HasSubstr("moved onto the nearest wall")));
}

TEST(GlazingReceivers, AnAzimuthIsFromTrueNorth) {
    const GlazingPlaced windows = placed({}, {{"a", {{50, 50, 3}}, 90.0, {}}});
    ASSERT_EQ(windows.receivers.size(), 1U);
    EXPECT_NEAR(windows.receivers.points.normals[0].x, 1, 1e-4);
    EXPECT_EQ(windows.receivers.elements[0].building, PointElement::noBuilding);
}

TEST(GlazingReceivers, WhatCannotBeMeasuredIsLeftOutAndListed) {
    const GlazingPlaced windows =
        placed(houseWithBalcony(), {{"inside", {{5, 5, 4}}, 180.0, {}},
                                    {"in the balcony", {{5, -0.5, 3.1}}, 180.0, {}},
                                    {"no wall", {{50, 50, 4}}, {}, {}},
                                    {"below", {{10, 5, -2}}, 90.0, {}},
                                    {"far", {{500, 5, 2}}, 90.0, {}},
                                    {"line", {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, {}, {}},
                                    {"good", {{10, 5, 2}}, 90.0, {}},
                                    {"good", {{10, 6, 2}}, 90.0, {}}});
    ASSERT_EQ(windows.receivers.size(), 2U);
    EXPECT_EQ(windows.receivers.elements[1].id, "good (2)");
    EXPECT_THAT(reasons(windows), ElementsAre(HasSubstr("inside a building"), HasSubstr("inside a building"),
                                              HasSubstr("no azimuth"), HasSubstr("below the ground"),
                                              HasSubstr("outside the region"), HasSubstr("no area"),
                                              HasSubstr("occurs again")));
    EXPECT_EQ(windows.warnings[1].where, "in the balcony");
}

// The box around the building is the region "city": its northern and eastern walls lie on the open edges of
// it.
TEST(GlazingReceivers, WindowsOnTheEdgeOfTheRegionCount) {
    const std::vector<GlazingShape> windows{{"east", {{10, 5, 2}}, 90.0, {}},
                                            {"north", {{5, 10.02, 2}}, 0.0, {}},
                                            {"west", {{-0.01, 5, 2}}, 270.0, {}},
                                            {"beyond", {{10.5, 5, 2}}, 90.0, {}}};
    const GlazingPlaced onEdge =
        placeGlazing(houseWithBalcony(), makeRegionFromLocalBox({{0, -1}, {10, 10}}), windows, {});
    EXPECT_EQ(onEdge.receivers.size(), 3U);
    EXPECT_THAT(reasons(onEdge), ElementsAre(HasSubstr("outside the region")));
}

TEST(WallFinder, FindsTheNearestOfSeveralWalls) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 9}}, {{10.5, 0, 0}, {20, 10, 9}}});
    const WallFinder walls(city);
    const auto near = walls.nearest({10.2, 5, 3});
    ASSERT_TRUE(near);
    EXPECT_EQ(near->building, 0U);
    EXPECT_NEAR(near->distanceM, 0.2, 1e-6);
    EXPECT_EQ(walls.nearest({10.3, 5, 3})->building, 1U);
    EXPECT_FALSE(walls.nearest({5, -1.5, 3}));
}

TEST(PlanePoints, LeaveOutWhatThePlaneCuts) {
    // 40 x 40 m in cells of 1 m; the building of 9 m takes 100 of them at 4 m, and none at 9 m.
    const Region region = makeRegionFromLocalBox({{-20, -20}, {20, 20}});
    const City city = cityOf({{{0, 0, 0}, {10, 10, 9}}});
    const PlanePoints low = placeOnPlane(city, region, {}, 4).value();
    EXPECT_EQ(low.receivers.size(), 1500U);
    EXPECT_EQ(low.insideBuildings, 100U);
    EXPECT_EQ(low.planeM, 4);
    EXPECT_EQ(placeOnPlane(city, region, {}, 9).value().receivers.size(), 1600U);
    EXPECT_FALSE(placeOnPlane(city, region, {}, -1));
    EXPECT_FALSE(placeOnPlane(city, region, {}, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(placeOnPlane(city, makeRegionFromLocalBox({{-20000, -20000}, {20000, 20000}}), {}, 4));
}

}  // namespace
}  // namespace noonmark
