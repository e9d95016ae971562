#include "core/city/terrain/tin_terrain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/city/terrain/post_grid.h"

namespace noonmark {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(FillGaps, AGapLiesBetweenItsRims) {
    // A strip of ten cells between elevations 0 and 11: filled about linearly, and never beyond the rims.
    constexpr int columns = 12, rows = 12;
    std::vector<float> values(std::size_t(columns) * rows, nan);
    for (int row = 0; row < rows; ++row) {
        values[std::size_t(row) * columns] = 0;
        values[std::size_t(row) * columns + columns - 1] = 11;
    }
    EXPECT_EQ(fillGaps(values, columns, rows), 120U);
    for (int row = 0; row < rows; ++row)
        for (int column = 1; column < columns; ++column) {
            const std::size_t cell = std::size_t(row) * columns + std::size_t(column);
            EXPECT_NEAR(values[cell], column, 1.5) << column;
            EXPECT_GE(values[cell], values[cell - 1]);
            EXPECT_NEAR(values[cell], values[cell % columns], 0.2);
        }
}

TEST(FillGaps, GroundBeyondASlopingRimHasNoTerraces) {
    // Known along a diagonal only, rising by 1 a cell. The nearest value alone makes steps of 1 there.
    constexpr int side = 64;
    std::vector<float> values(std::size_t(side) * side, nan);
    for (int at = 0; at < side; ++at) values[std::size_t(at) * side + std::size_t(at)] = float(at);
    fillGaps(values, side, side);
    for (int row = 1; row + 1 < side; ++row)
        for (int column = row + 4; column + 1 < side; ++column) {
            const std::size_t cell = std::size_t(row) * side + std::size_t(column);
            const float bend = values[cell - 1] + values[cell + 1] - 2 * values[cell];
            EXPECT_LT(std::abs(bend), 0.25F) << column << ' ' << row;
        }
}

TEST(FillGaps, NothingToFillOrNothingToFillFrom) {
    std::vector<float> whole{1, 2, 3};
    EXPECT_EQ(fillGaps(whole, 3, 1), 0U);
    std::vector<float> empty(6, nan);
    EXPECT_EQ(fillGaps(empty, 3, 2), 0U);
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
    for (const float z : made->terrain.elevationM) EXPECT_TRUE(z >= 5 && z <= 8) << z;
}

TEST(TinTerrain, WithoutAreaThereIsNone) {
    EXPECT_FALSE(rasterizeTin({}));
    EXPECT_FALSE(rasterizeTin({{{0, 0, 0}, {1, 0, 0}, {2, 0, 9}}, {{0, 1, 2}}}));
}

}  // namespace
}  // namespace noonmark
