#include "core/receivers/points/facade_elevations.h"

#include <gmock/gmock.h>

#include <set>

#include "core/receivers/point_receivers.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

std::vector<ElevationPane> panesOn(const City& city) {
    const PointReceivers facades =
        placeOnFacades(city, std::vector<std::uint32_t>{0}, {.storeyM = 3}).value();
    std::vector<ElevationPane> panes;
    for (std::size_t i = 0; i < facades.size(); ++i)
        panes.push_back({glm::dvec3(facades.points.positions[i]),
                         glm::dvec3(facades.points.normals[i]),
                         {{-0.75, -0.75}, {0.75, 0.75}}});
    return panes;
}

// 12 x 6 m, 10 m high, with windows of 1.5 m at 1.5, 4.5 and 7.5 m in bays of 3 m.
TEST(FacadeElevations, ABoxHasFourSidesWithTheirWindowsAtTheirPlaces) {
    const City city = cityOf({{{0, 0, 0}, {12, 6, 10}}});
    const auto panes = panesOn(city);
    const auto sides = drawElevations(city.buildings[0].get(), panes);
    ASSERT_EQ(sides.size(), 4U);
    // By azimuth: north, east, south, west.
    for (const std::size_t side : {0, 1, 2, 3}) {
        EXPECT_EQ(sides[side].layers, 1);
        ASSERT_EQ(sides[side].faces.size(), 1U);
        EXPECT_EQ(sides[side].windows.size(), side % 2 == 0 ? 12U : 6U);
        EXPECT_NEAR(sides[side].high.x - sides[side].low.x, side % 2 == 0 ? 12 : 6, 1e-5);
        EXPECT_NEAR(sides[side].high.y, 10, 1e-5);
        EXPECT_EQ(sides[side].floorM, 0);
    }
    // From the south, east is at the right; from the north, west is.
    for (const ElevationGlazing& window : sides[2].windows) {
        const ElevationPane& pane = panes[window.pane];
        EXPECT_NEAR(window.low.x, pane.middle.x - 0.75, 1e-5);
        EXPECT_NEAR(window.high.y, pane.middle.z + 0.75, 1e-5);
    }
    for (const ElevationGlazing& window : sides[0].windows)
        EXPECT_NEAR(window.high.x, -panes[window.pane].middle.x + 0.75, 1e-5);
}

// A court that opens to nothing: its southern wall faces north, behind the northern wing.
TEST(FacadeElevations, WindowsOfACourtHaveALayerOfTheirOwn) {
    City city;
    Footprint court{rectangle(0, 0, 30, 30), {rectangle(10, 10, 20, 20)}};
    std::ranges::reverse(court.holes[0]);
    city.buildings.push_back(buildingOf(court, 0, 9));
    const auto panes = panesOn(city);
    const auto sides = drawElevations(city.buildings[0].get(), panes);
    ASSERT_EQ(sides.size(), 8U);
    std::set<std::size_t> drawn;
    for (const FacadeElevation& side : sides) {
        EXPECT_EQ(side.layers, 2);
        EXPECT_EQ(side.windows.size(), side.layer == 1 ? 30U : 9U);
        if (side.layer == 2) {
            EXPECT_NEAR(side.high.x - side.low.x, 10, 1e-5) << "its own wall only";
        }
        for (const ElevationGlazing& window : side.windows) drawn.insert(window.pane);
    }
    EXPECT_EQ(drawn.size(), panes.size()) << "each window once";
}

// Only the court's windows are asked for: the wings in front of them make no picture of their own.
TEST(FacadeElevations, WindowsThatNearerWallsAllCoverAreDrawnAlone) {
    City city;
    Footprint court{rectangle(0, 0, 30, 30), {rectangle(10, 10, 20, 20)}};
    std::ranges::reverse(court.holes[0]);
    city.buildings.push_back(buildingOf(court, 0, 9));
    auto panes = panesOn(city);
    std::erase_if(panes, [](const ElevationPane& pane) {
        const glm::dvec2 place(pane.middle);
        return std::min({place.x, place.y, 30 - place.x, 30 - place.y}) < 5;
    });
    const auto sides = drawElevations(city.buildings[0].get(), panes);
    ASSERT_EQ(sides.size(), 4U);
    for (const FacadeElevation& side : sides) {
        EXPECT_EQ(side.windows.size(), 9U);
        EXPECT_EQ(side.layers, 1);
    }
}

// A wing 4 m in front of the main wall, half as high: the windows above it belong to the same picture.
TEST(FacadeElevations, WallsBehindALowerWingAreDrawnAboveIt) {
    City city = cityOf({{{0, 0, 0}, {12, 6, 12}}});
    Building building = *city.buildings[0];
    building.parts.push_back(buildingOf(Box3{{0, -4, 0}, {12, 0, 6}})->parts[0]);
    city.buildings[0] = std::make_shared<const Building>(building);
    const auto panes = panesOn(city);
    const auto sides = drawElevations(city.buildings[0].get(), panes);
    ASSERT_EQ(sides.size(), 4U);
    const FacadeElevation& south = sides[2];
    ASSERT_EQ(south.faces.size(), 2U);
    EXPECT_LT(south.faces[0].depthM, south.faces[1].depthM) << "from back to front";
    EXPECT_EQ(south.windows.size(), 16U);
}

TEST(FacadeElevations, RoofWindowsHaveNoneAndWindowsWithoutWallsHave) {
    const std::vector<ElevationPane> panes{{{0, 0, 5}, {0, 0, 1}, {{-1, -1}, {1, 1}}},
                                           {{4, 0, 5}, {0, -1, 0}, {{-1, -1}, {1, 1}}}};
    const auto sides = drawElevations(nullptr, panes);
    ASSERT_EQ(sides.size(), 1U);
    EXPECT_TRUE(sides[0].faces.empty());
    ASSERT_EQ(sides[0].windows.size(), 1U);
    EXPECT_EQ(sides[0].windows[0].pane, 1U);
    EXPECT_EQ(sides[0].low, glm::dvec2(3, 4));
}

// Two walls that cross in plan, as those of a twisted tower: the western half of the one and the eastern half
// of the other lie in front, and each hides a window of the other. Two windows without a wall make the side
// face due south.
TEST(FacadeElevations, WindowsOfWallsThatCoverEachOtherAreDrawn) {
    const TriangleMesh walls{.vertices = {{-20, -1, 0},
                                          {20, 1, 0},
                                          {20, 1, 10},
                                          {-20, -1, 10},
                                          {-20, 1, 0},
                                          {20, -1, 0},
                                          {20, -1, 10},
                                          {-20, 1, 10}},
                             .triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
    Building building;
    building.parts.push_back({.footprint = {rectangle(-20, -1, 20, 1), {}},
                              .topM = 10,
                              .mesh = std::make_shared<const TriangleMesh>(walls)});
    const double length = std::hypot(40, 2);
    const PaneSize size{{-0.5, -0.5}, {0.5, 0.5}};
    const std::vector<ElevationPane> panes{{{16, 0.8, 5}, {2 / length, -40 / length, 0}, size},
                                           {{-16, 0.8, 5}, {-2 / length, -40 / length, 0}, size},
                                           {{30, 0, 5}, {0, -1, 0}, size},
                                           {{32, 0, 5}, {0, -1, 0}, size}};
    std::set<std::size_t> drawn;
    for (const FacadeElevation& side : drawElevations(&building, panes))
        for (const ElevationGlazing& window : side.windows) drawn.insert(window.pane);
    EXPECT_EQ(drawn.size(), panes.size());
}

}  // namespace
}  // namespace noonmark
