#include "core/city/terrain/terrain.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "core/city/city.h"

namespace noonmark {
namespace {

Terrain randomTerrain(std::mt19937& random) {
    Terrain terrain{{-30, 20, 5, 7, 6}, {}};
    for (std::size_t i = 0; i < terrain.grid.size(); ++i)
        terrain.elevationM.push_back(float(random() % 400) / 10);
    return terrain;
}

TEST(Terrain, IsItsElevationAtCellCentres) {
    std::mt19937 random(5);
    const Terrain terrain = randomTerrain(random);
    for (int row = 0; row < terrain.grid.rows; ++row)
        for (int column = 0; column < terrain.grid.columns; ++column)
            EXPECT_FLOAT_EQ(elevationAt(terrain, terrain.grid.centre(column, row)),
                            terrain.elevationM[terrain.grid.index(column, row)]);
}

TEST(Terrain, KeepsASlopeThatIsPlane) {
    Terrain terrain{{0, 0, 2, 10, 10}, {}};
    const auto plane = [](glm::dvec2 p) { return 3 + 0.25 * p.x - 0.5 * p.y; };
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 10; ++column)
            terrain.elevationM.push_back(float(plane(terrain.grid.centre(column, row))));
    for (const glm::dvec2 point :
         {glm::dvec2{1, 1}, glm::dvec2{7.3, 9.1}, glm::dvec2{18.9, 1.1}, glm::dvec2{11.5, 12.5}})
        EXPECT_NEAR(elevationAt(terrain, point), plane(point), 1e-5);
}

TEST(Terrain, BeyondTheOuterCentresIsTheNearestValue) {
    const Terrain terrain{{0, 0, 10, 2, 2}, {1, 2, 3, 4}};
    EXPECT_FLOAT_EQ(elevationAt(terrain, {-1000, -1000}), 1);
    EXPECT_FLOAT_EQ(elevationAt(terrain, {1000, -1000}), 2);
    EXPECT_FLOAT_EQ(elevationAt(terrain, {-1000, 1000}), 3);
    EXPECT_FLOAT_EQ(elevationAt(terrain, {1000, 1000}), 4);
    EXPECT_FLOAT_EQ(elevationAt({{0, 0, 10, 1, 1}, {7}}, {3, 400}), 7);
}

TEST(Terrain, IsTheSurfaceOfItsMesh) {
    std::mt19937 random(6);
    const Terrain terrain = randomTerrain(random);
    const TriangleMesh mesh = meshOf(terrain);
    EXPECT_EQ(mesh.triangles.size(), std::size_t(2 * 6 * 5));
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        EXPECT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0);
        const glm::dvec3 middle = a * 0.5 + b * 0.3 + c * 0.2;
        EXPECT_NEAR(elevationAt(terrain, {middle.x, middle.y}), middle.z, 1e-4);
    }
}

TEST(City, GroundIsFlatAtZeroWithoutTerrain) {
    City city;
    EXPECT_EQ(groundAt(city, {12, 34}), 0);
    city.terrain = std::make_shared<const Terrain>(Terrain{{0, 0, 10, 1, 1}, {7}});
    EXPECT_EQ(groundAt(city, {12, 34}), 7);
}

}  // namespace
}  // namespace noonmark
