#include "core/receivers/point_receivers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

PointReceivers onFacadesOf(const City& city, const std::vector<std::uint32_t>& buildings,
                           const FacadeSettings& settings = {.storeyM = 3}) {
    return placeOnFacades(city, buildings, settings).value();
}

// The same box as a mesh.
City asMesh(const Box3& box) {
    Building building = *buildingOf(box);
    building.parts[0].mesh = std::make_shared<const TriangleMesh>(meshOf(building.parts[0]));
    City city;
    city.buildings.push_back(std::make_shared<const Building>(building));
    return city;
}

TEST(PointReceivers, OnePerStoreyAndBayOfEachWall) {
    // 12 x 6 m and 10 m high: 4 + 2 + 4 + 2 bays; receivers at 1.5, 4.5 and 7.5 m.
    const Box3 box{{0, 0, 0}, {12, 6, 10}};
    for (const City& city : {cityOf({box}), asMesh(box)}) {
        const PointReceivers facades = onFacadesOf(city, {0});
        EXPECT_EQ(facades.size(), 36U);
        std::set<std::string> ids;
        for (std::size_t i = 0; i < facades.size(); ++i) {
            const glm::vec3 at = facades.points.positions[i], normal = facades.points.normals[i];
            ids.insert(facades.elements[i].id);
            EXPECT_EQ(at.z, 1.5F + 3 * float(facades.elements[i].floor));
            const float out = normal.x > 0.5F    ? at.x - 12
                              : normal.x < -0.5F ? -at.x
                              : normal.y > 0     ? at.y - 6
                                                 : -at.y;
            EXPECT_NEAR(out, 0, 1e-5);
        }
        EXPECT_EQ(ids.size(), 36U);
    }
}

// Two boxes of 14 m: the second states storeys of 4.2 m. Points stand 1.5 m above each floor.
TEST(PointReceivers, AreOnTheStoreysThatTheirBuildingStates) {
    City city = cityOf({{{0, 0, 0}, {3, 3, 14}}, {{50, 0, 0}, {53, 3, 14}}});
    Building tower = *city.buildings[1];
    tower.sourceId = "tower";
    city.buildings[1] = std::make_shared<const Building>(tower);
    const OwnStoreys own{{"tower", 4.2}};
    const auto facades = placeOnFacades(city, std::array{0U, 1U}, {}, {}, own).value();
    std::map<std::uint32_t, std::set<float>> heights;
    for (std::size_t i = 0; i < facades.size(); ++i)
        heights[facades.elements[i].building].insert(facades.points.positions[i].z);
    EXPECT_EQ(heights[0], (std::set<float>{1.5F, 5, 8.5F, 12}));
    EXPECT_EQ(heights[1], (std::set<float>{1.5F, 5.7F, 9.9F}));
    for (std::size_t i = 0; i < facades.size(); ++i)
        if (facades.elements[i].building == 1 && facades.elements[i].floor == 0) {
            EXPECT_NEAR(facades.panes[i].high.y, 4.2 - 1.5, 1e-9);
        }
}

TEST(PointReceivers, ASharedWallIsNoFacade) {
    // Wall to wall along x = 10; the second is 10 m higher: its western wall is open from 10 m on.
    const City city = cityOf({{{0, 0, 0}, {10, 6, 10}}, {{10, 0, 0}, {16, 6, 20}}});
    const auto westernOf = [](const PointReceivers& facades) {
        std::vector<float> heights;
        for (std::size_t i = 0; i < facades.size(); ++i)
            if (facades.points.normals[i].x < -0.5F) heights.push_back(facades.points.positions[i].z);
        std::ranges::sort(heights);
        return heights;
    };
    EXPECT_EQ(westernOf(onFacadesOf(city, {1})),
              (std::vector<float>{10.5, 10.5, 13.5, 13.5, 16.5, 16.5, 19.5, 19.5}));
    const PointReceivers first = onFacadesOf(city, {0});
    EXPECT_TRUE(std::ranges::none_of(first.points.normals, [](glm::vec3 n) { return n.x > 0.5F; }));
}

TEST(PointReceivers, RefusesSettingsOutOfRange) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    const std::array<std::uint32_t, 1> first{0}, other{7};
    EXPECT_FALSE(placeOnFacades(city, first, {.bayM = 0}));
    EXPECT_FALSE(placeOnFacades(city, first, {.storeyM = std::numeric_limits<double>::quiet_NaN()}));
    EXPECT_FALSE(placeOnFacades(city, first, {.aboveFloorM = 3.6}));
    EXPECT_FALSE(placeOnFacades(city, other, {}));
}

TEST(PointReceivers, BuildingsOfARegion) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 10}}, {{50, 0, 0}, {60, 10, 10}}});
    EXPECT_EQ(findBuildingsIn(city, makeRegionFromLocalBox({{40, -5}, {70, 20}})),
              (std::vector<std::uint32_t>{1}));
}

}  // namespace
}  // namespace noonmark
