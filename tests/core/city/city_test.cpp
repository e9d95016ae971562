#include "core/city/city.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/core/city/footprint_checks.h"

namespace noonmark {
namespace {

Part box(float west, float south, float side, float bottom, float top) {
    const Ring ring{{west, south}, {west + side, south}, {west + side, south + side}, {west, south + side}};
    return {.footprint = {ring, {}}, .bottomM = bottom, .topM = top};
}

City twoBuildings() {
    City city;
    city.buildings.push_back(
        std::make_shared<const Building>(Building{.parts = {box(0, 0, 10, 0, 20), box(2, 2, 4, 20, 90)}}));
    city.buildings.push_back(std::make_shared<const Building>(Building{.parts = {box(30, -5, 10, 0, 15)}}));
    return city;
}

TEST(City, MeshNamesTheBuildingOfEveryTriangle) {
    const City city = twoBuildings();
    const CityMesh all = meshOf(city);
    ASSERT_EQ(all.buildingOfTriangle.size(), all.mesh.triangles.size());
    EXPECT_EQ(all.mesh.triangles.size(), 36U);
    for (std::size_t i = 0; i < all.mesh.triangles.size(); ++i) {
        const Box2 box = bounds(*city.buildings[all.buildingOfTriangle[i]]);
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 p = all.mesh.vertices[all.mesh.triangles[i][corner]];
            EXPECT_TRUE(p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y);
        }
    }
    EXPECT_EQ(tests::openEdgesOf(all.mesh), 0);
    EXPECT_NEAR(tests::computeVolume(all.mesh), 2000 + 16 * 70 + 1500, 1e-6);
}

TEST(City, BoundsAndTops) {
    const City city = twoBuildings();
    EXPECT_EQ(bounds(city), (Box2{{0, -5}, {40, 10}}));
    EXPECT_EQ(topM(*city.buildings[0]), 90);
    EXPECT_TRUE(bounds(City{}).empty());
}

TEST(City, EverySourceOfAHeightHasItsOwnName) {
    for (std::size_t i = 0; i < heightSources.size(); ++i) {
        EXPECT_EQ(std::size_t(heightSources[i]), i);
        EXPECT_EQ(parseHeightSource(nameOf(heightSources[i])), heightSources[i]);
    }
    EXPECT_EQ(nameOf(HeightSource::designed), "designed");
    EXPECT_EQ(nameOf(HeightSource::madeUp), "made up");
    EXPECT_EQ(parseHeightSource("unknown"), std::nullopt);
}

TEST(City, APartWithItsOwnMeshKeepsIt) {
    Part part = box(0, 0, 10, 0, 20);
    part.mesh = std::make_shared<const TriangleMesh>(
        TriangleMesh{{glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)}, {glm::uvec3(0, 1, 2)}});
    EXPECT_EQ(meshOf(part), *part.mesh);
}

}  // namespace
}  // namespace noonmark
