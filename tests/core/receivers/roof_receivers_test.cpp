#include <gtest/gtest.h>
#include <algorithm>

#include "core/receivers/roof_receivers.h"
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

namespace noonmark::tests {

namespace {

Receivers placeReceiversAt(const City& city, ReceiverPlaces places) {
    return placeReceivers(city, makeRegionFromLocalBox({{-20, -20}, {60, 60}}), {1, places}).value();
}

City tiered() {
    City city = cityOf({{{0, 0, 0}, {40, 40, 10}}, {{50, 0, 6}, {60, 20, 9}}});
    Building building = *city.buildings[0];
    building.parts.push_back(buildingOf({rectangle(10, 10, 20, 20), {}}, 10, 35)->parts[0]);
    city.buildings[0] = std::make_shared<const Building>(building);
    return city;
}

TEST(RoofReceivers, ARoofIsTheHighestPartAtACell) {
    const Receivers roofs = placeReceiversAt(tiered(), ReceiverPlaces::roofs);
    EXPECT_EQ(roofs.cells.size(), 40 * 40);  // the deck over open ground has none
    for (const std::uint32_t cell : roofs.cells) {
        const glm::vec3 at = roofs.position(cell);
        const bool high = at.x > 10 && at.x < 20 && at.y > 10 && at.y < 20;
        EXPECT_EQ(at.z, high ? 35 : 10);
        EXPECT_EQ(roofs.kind[cell], CellKind::roof);
    }
    EXPECT_EQ(std::ranges::count(roofs.kind, CellKind::ground), 0);
}

TEST(RoofReceivers, EveryPlaceIsFoundByItsName) {
    EXPECT_EQ(nameOf(ReceiverPlaces::roofs), "roofs");
    EXPECT_EQ(findChoice<ReceiverPlaces>(receiverPlaceChoices, "both"), ReceiverPlaces::both);
    EXPECT_EQ(findChoice<ReceiverPlaces>(receiverPlaceChoices, "Roofs"), std::nullopt);
}

TEST(RoofReceivers, BothAreTheGroundAndTheRoofs) {
    const City city = tiered();
    const Receivers ground = placeReceiversAt(city, ReceiverPlaces::ground),
                    roofs = placeReceiversAt(city, ReceiverPlaces::roofs),
                    both = placeReceiversAt(city, ReceiverPlaces::both);
    EXPECT_TRUE(ground.flat());
    EXPECT_EQ(both.cells.size(), ground.cells.size() + roofs.cells.size());
    EXPECT_TRUE(std::ranges::is_sorted(both.cells));
    for (const std::uint32_t cell : ground.cells) EXPECT_EQ(both.position(cell), ground.position(cell));
    for (const std::uint32_t cell : roofs.cells) EXPECT_EQ(both.position(cell), roofs.position(cell));
}

TEST(RoofReceivers, APitchedRoofRisesToItsRidge) {
    City city;
    city.buildings.push_back(gabledHouse(0, 0, 12, 40, 8, 14));
    const Receivers roofs = placeReceiversAt(city, ReceiverPlaces::roofs);
    EXPECT_EQ(roofs.cells.size(), 12 * 40);
    for (const std::uint32_t cell : roofs.cells) {
        const glm::vec3 at = roofs.position(cell);
        EXPECT_NEAR(at.z, 14 - std::abs(at.x - 6), 1e-4);
    }
}

TEST(RoofReceivers, TheGroundBesideRoofsKeepsTheTerrainsElevation) {
    City city = groundOf(20, [](glm::dvec2 place) { return 50 + 0.1 * place.y; });
    city.buildings.push_back(standingBox(city, 0, 0, 10, 10, 20));
    const Receivers both = placeReceiversAt(city, ReceiverPlaces::both);
    for (const std::uint32_t cell : both.cells) {
        const glm::vec3 at = both.position(cell);
        EXPECT_NEAR(at.z, both.kind[cell] == CellKind::roof ? 70 : 50 + 0.1F * at.y, 1e-3);
    }
}

}  // namespace

}  // namespace noonmark::tests
