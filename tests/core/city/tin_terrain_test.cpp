#include "core/city/terrain/tin_terrain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/city/terrain/post_grid.h"

namespace noonmark {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(FillGaps, NearestValueWins) {
    std::vector<float> values{1, nan, nan, nan, 2, nan, nan, nan, nan, nan};
    EXPECT_EQ(fillFromNearest(values, 5, 2), 8U);
    EXPECT_EQ(values[1], 1);
    EXPECT_EQ(values[3], 2);
    EXPECT_EQ(values[5], 1);
    EXPECT_EQ(values[9], 2);
    for (const float value : values) EXPECT_TRUE(value == 1 || value == 2);
}

TEST(FillGaps, NothingToFillOrNothingToFillFrom) {
    std::vector<float> whole{1, 2, 3};
    EXPECT_EQ(fillFromNearest(whole, 3, 1), 0U);
    std::vector<float> empty(6, nan);
    EXPECT_EQ(fillFromNearest(empty, 3, 2), 0U);
    EXPECT_TRUE(std::isnan(empty[0]));
}

TEST(TinTerrain, APlaneComesBackExactly) {
    TriangleMesh tin;
    for (const glm::vec2 at : {glm::vec2(-50, -20), {50, -20}, {50, 80}, {-50, 80}, {3, 31}})
        tin.vertices.emplace_back(at, 10 + 0.1F * at.x - 0.05F * at.y);
    tin.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const auto made = rasterizeTin(tin);
    ASSERT_TRUE(made);
    const Terrain& terrain = made->terrain;
    EXPECT_EQ(made->filled, 0U);
    EXPECT_NEAR(bounds(terrain.grid).low.x, -50, terrain.grid.cellM);
    EXPECT_NEAR(bounds(terrain.grid).high.y, 80, terrain.grid.cellM);
    for (const glm::dvec2 at : {glm::dvec2(-30, 0), {0, 0}, {20, 60}})
        EXPECT_NEAR(elevationAt(terrain, at), 10 + 0.1 * at.x - 0.05 * at.y, 0.01);
}

TEST(TinTerrain, HolesAreFilledAndCounted) {
    TriangleMesh tin;
    tin.vertices = {{0, 0, 5}, {10, 0, 5}, {0, 10, 5}, {40, 40, 8}, {40, 30, 8}, {30, 40, 8}};
    tin.triangles = {{0, 1, 2}, {3, 5, 4}};
    const auto made = rasterizeTin(tin);
    ASSERT_TRUE(made);
    EXPECT_GT(made->filled, 0U);
    for (const float z : made->terrain.elevationM) EXPECT_TRUE(z == 5 || z == 8);
}

TEST(TinTerrain, WithoutAreaThereIsNone) {
    EXPECT_FALSE(rasterizeTin({}));
    EXPECT_FALSE(rasterizeTin({{{0, 0, 0}, {1, 0, 0}, {2, 0, 9}}, {{0, 1, 2}}}));
}

}  // namespace
}  // namespace noonmark
