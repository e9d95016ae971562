#include "core/city/terrain/post_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/city/terrain/terrain.h"

namespace noonmark {
namespace {

// Turned by 20 degrees, with cells of 2 by 3 m that are not quite rectangles, and bent by up to some
// decimetres.
PostGrid askew() {
    PostGrid posts;
    posts.columns = 30;
    posts.rows = 20;
    posts.first = {-40, 15};
    posts.columnStep = {1.88, 0.68};
    posts.rowStep = {-0.95, 2.84};
    posts.cellM = std::sqrt(1.88 * 2.84 + 0.68 * 0.95);
    posts.bend = {glm::dvec2{0.3, -0.2}, {0.1, 0.25}, {-0.2, 0.1}, {0.05, 0.02}, {0, 0.04}, {-0.03, 0},
                  {0.02, -0.05}};
    return posts;
}

Terrain roughOn(const PostGrid& posts) {
    std::mt19937 random(8);
    Terrain terrain{posts, {}};
    for (std::size_t i = 0; i < posts.size(); ++i) terrain.elevationM.push_back(float(random() % 500) / 100);
    return terrain;
}

TEST(PostGrid, OfAGridAreItsCentres) {
    const Grid grid{-30, 20, 5, 7, 6};
    const PostGrid posts = grid;
    EXPECT_FALSE(posts.isBent());
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            EXPECT_EQ(posts.centre(column, row), grid.centre(column, row));
            EXPECT_EQ(posts.index(column, row), grid.index(column, row));
        }
}

TEST(PostGrid, ColumnsAndRowsOfAPlaceAreFoundAgain) {
    const PostGrid posts = askew();
    for (double row = -3; row <= 23; row += 0.7)
        for (double column = -4; column <= 33; column += 0.9) {
            const glm::dvec2 found = posts.columnRowOf(posts.centre(column, row));
            ASSERT_NEAR(found.x, column, 1e-9);
            ASSERT_NEAR(found.y, row, 1e-9);
        }
}

TEST(PostGrid, StepsAreTheWayToTheNextPost) {
    const PostGrid posts = askew();
    constexpr double little = 1e-5;
    const glm::dvec2 at(7.3, 11.8), here = posts.centre(at.x, at.y);
    const PostGrid::Steps steps = posts.stepsAt(at);
    EXPECT_LT(glm::distance(steps.column, (posts.centre(at.x + little, at.y) - here) / little), 1e-6);
    EXPECT_LT(glm::distance(steps.row, (posts.centre(at.x, at.y + little) - here) / little), 1e-6);
}

TEST(PostGrid, BoundsHoldEveryPost) {
    const PostGrid posts = askew();
    const Box2 box = bounds(posts);
    for (int row = 0; row < posts.rows; ++row)
        for (int column = 0; column < posts.columns; ++column) {
            const glm::vec2 post(posts.centre(column, row));
            EXPECT_TRUE(post.x >= box.low.x && post.y >= box.low.y && post.x <= box.high.x &&
                        post.y <= box.high.y);
        }
}

TEST(PostGrid, DistancesBeyondItCountFromTheOuterPosts) {
    const PostGrid posts(0, 0, 10, 5, 4);  // posts from (5, 5) to (45, 35)
    EXPECT_EQ(beyondM(posts, {20, 20}), 0);
    EXPECT_EQ(beyondM(posts, {49.9, 0.1}), 0);  // half a cell counts as covered
    EXPECT_DOUBLE_EQ(beyondM(posts, {55, 20}), 10);
    EXPECT_DOUBLE_EQ(beyondM(posts, {75, -35}), 50);
    EXPECT_NEAR(beyondM(askew(), askew().centre(40, 5)),
                glm::distance(askew().centre(40, 5), askew().centre(29, 5)), 0.5);
    EXPECT_NEAR(beyondM(askew(), {50000, 15}), 50000, 100);
}

TEST(PostGrid, OfABentTerrainTheGroundIsTheSurfaceOfItsMesh) {
    const Terrain terrain = roughOn(askew());
    const TriangleMesh mesh = meshOf(terrain);
    std::mt19937 random(3);
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        EXPECT_GT((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 0);
        const double u = 0.98 * double(random() % 1000) / 1000 + 0.01,
                     v = (1 - u) * double(random() % 1000) / 1000;
        const glm::dvec3 inside = a * (1 - u - v) + b * u + c * v;
        ASSERT_NEAR(elevationAt(terrain, {inside.x, inside.y}), inside.z, 2e-5);
    }
}

TEST(PostGrid, OfABentTerrainTheNearestValueStandsBeyond) {
    const Terrain terrain = roughOn(askew());
    EXPECT_FLOAT_EQ(elevationAt(terrain, askew().centre(-20, -15)), terrain.elevationM.front());
    EXPECT_FLOAT_EQ(elevationAt(terrain, askew().centre(60, 40)), terrain.elevationM.back());
    EXPECT_TRUE(std::isfinite(elevationAt(terrain, {1e6, -1e6})));
}

}  // namespace
}  // namespace noonmark
