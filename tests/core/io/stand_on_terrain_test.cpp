#include "core/io/terrain/buildings_on_terrain.h"

#include <gtest/gtest.h>
#include <cmath>

#include "core/city/city.h"

namespace noonmark {
namespace {

// A slope that rises by one metre in ten towards the east, with a pit in the middle of the map.
Terrain slope() {
    Terrain terrain{{-100, -100, 2, 100, 100}, {}};
    for (int row = 0; row < 100; ++row)
        for (int column = 0; column < 100; ++column) {
            const glm::dvec2 centre = terrain.grid.centre(column, row);
            const bool pit = std::abs(centre.x) < 3 && std::abs(centre.y) < 3;
            terrain.elevationM.push_back(pit ? -20.0F : float(centre.x / 10));
        }
    return terrain;
}

Building tower(float west, float bottom, float top) {
    Building building;
    building.parts.push_back({.footprint = {{{west, -10}, {west + 20, -10}, {west + 20, 10}, {west, 10}}, {}},
                              .bottomM = bottom,
                              .topM = top});
    return building;
}

TEST(StandOnTerrain, LiftsByTheLowestGround) {
    const Terrain terrain = slope();
    const Building placed = standOnTerrain(tower(40, 0, 30), std::nullopt, &terrain);
    EXPECT_NEAR(placed.parts[0].bottomM, 4, 1e-3);
    EXPECT_NEAR(placed.parts[0].topM, 34, 1e-3);
}

TEST(StandOnTerrain, FindsThePitInsideTheOutline) {
    const Terrain terrain = slope();
    EXPECT_FLOAT_EQ(findLowestGround(tower(-10, 0, 30), terrain), -20);
}

TEST(StandOnTerrain, AGroundOfItsOwnStaysAndWallsGoDown) {
    const Terrain terrain = slope();
    const Building placed = standOnTerrain(tower(40, 7, 37), 7.0F, &terrain);
    EXPECT_NEAR(placed.parts[0].bottomM, 4, 1e-3);
    EXPECT_NEAR(placed.parts[0].topM, 37, 1e-3);  // minus a little for the earth's curvature
    Building overhanging = tower(40, 12, 37);
    overhanging.parts[0].isOverhanging = true;
    EXPECT_NEAR(standOnTerrain(overhanging, 7.0F, &terrain).parts[0].bottomM, 12, 1e-3);
}

TEST(StandOnTerrain, WithoutTerrainTheGroundIsFlat) {
    const Building placed = standOnTerrain(tower(40, 7, 37), 7.0F, nullptr);
    EXPECT_FLOAT_EQ(placed.parts[0].bottomM, 0);
    EXPECT_FLOAT_EQ(placed.parts[0].topM, 30);
    EXPECT_FLOAT_EQ(standOnTerrain(tower(40, 0, 30), std::nullopt, nullptr).parts[0].topM, 30);
}

TEST(StandOnTerrain, ABuildingSmallerThanACellStandsToo) {
    const Terrain terrain = slope();
    Building shed;
    shed.parts.push_back(
        {.footprint = {{{50, 50}, {50.1F, 50}, {50.1F, 50.1F}}, {}}, .bottomM = 0, .topM = 3});
    EXPECT_NEAR(standOnTerrain(shed, std::nullopt, &terrain).parts[0].bottomM, 5, 0.01);
}

TEST(StandOnTerrain, AMeshMovesWithItsPart) {
    Building building = tower(40, 7, 37);
    building.parts[0].mesh = std::make_shared<const TriangleMesh>(meshOf(building.parts[0]));
    const Terrain terrain = slope();
    const Part onFlat = standOnTerrain(building, 7.0F, nullptr).parts[0];
    EXPECT_FLOAT_EQ(onFlat.bottomM, 0);
    for (const glm::vec3 vertex : onFlat.mesh->vertices)
        EXPECT_TRUE(vertex.z == 0 || vertex.z == 30) << vertex.z;
    // On terrain it keeps its own elevations: the walls of a mesh cannot be extended.
    const Part onTerrain = standOnTerrain(building, 7.0F, &terrain).parts[0];
    EXPECT_NEAR(onTerrain.bottomM, 7, 1e-3);
    for (const glm::vec3 vertex : onTerrain.mesh->vertices)
        EXPECT_TRUE(std::abs(vertex.z - 7) < 1e-3F || std::abs(vertex.z - 37) < 1e-3F) << vertex.z;
}

}  // namespace
}  // namespace noonmark
