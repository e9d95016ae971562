#include "core/receivers/roof_receivers.h"

#include <gtest/gtest.h>

#include "tests/core/engines/scenes.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark {
namespace {

TEST(CityAbovePlane, LowersWhatStandsAboveAndLeavesOutTheRest) {
    // A house of 3 m, a tower of 20 m, and a bridge from 6 to 8 m, cut at 4 m.
    const City city = tests::cityOf({{{0, 0, 0}, {10, 10, 3}}, {{20, 0, 0}, {30, 10, 20}}});
    City withBridge = city;
    Building bridge = *tests::buildingOf(tests::Box3{{40, 0, 6}, {50, 10, 8}});
    bridge.parts.front().isOverhanging = true;
    withBridge.buildings.push_back(std::make_shared<const Building>(std::move(bridge)));
    const auto above = cutAbovePlane(withBridge, 4);
    ASSERT_TRUE(above);
    ASSERT_EQ(above->buildings.size(), 2U);
    EXPECT_FLOAT_EQ(above->buildings[0]->parts.front().topM, 16);
    EXPECT_FLOAT_EQ(above->buildings[0]->parts.front().bottomM, 0);
    EXPECT_FLOAT_EQ(above->buildings[1]->parts.front().bottomM, 2);
    EXPECT_TRUE(above->buildings[1]->parts.front().isOverhanging);
    // At 7 m the plane cuts the bridge, which then stands on it.
    const auto higher = cutAbovePlane(withBridge, 7);
    ASSERT_TRUE(higher);
    EXPECT_FLOAT_EQ(higher->buildings[1]->parts.front().bottomM, 0);
    EXPECT_FALSE(higher->buildings[1]->parts.front().isOverhanging);
}

TEST(CityAbovePlane, MeshesAndTerrainCannotBeCut) {
    City city = tests::cityOf({{{0, 0, 0}, {10, 10, 30}}});
    city.terrain = std::make_shared<const Terrain>();
    EXPECT_FALSE(cutAbovePlane(city, 4));
    city.terrain = nullptr;
    Building mesh = *city.buildings.front();
    mesh.parts.front().mesh = std::make_shared<const TriangleMesh>();
    city.buildings.push_back(std::make_shared<const Building>(std::move(mesh)));
    EXPECT_FALSE(cutAbovePlane(city, 4));
}

}  // namespace
}  // namespace noonmark
