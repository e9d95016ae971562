#include "core/city/footprints/footprint.h"

#include <gtest/gtest.h>

#include "core/city/city.h"
#include "core/city/footprints/triangulate.h"
#include "core/receivers/rasterize.h"

namespace noonmark {
namespace {

Ring square(float x, float y, float side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}
Ring reversed(Ring ring) { return {ring.rbegin(), ring.rend()}; }

TEST(Footprint, AreaOfASquareWithAHole) {
    EXPECT_DOUBLE_EQ(area({square(0, 0, 10), {reversed(square(2, 2, 3))}}), 91);
    EXPECT_DOUBLE_EQ(signedArea(square(1e4F, 1e4F, 10)), 100);
    EXPECT_DOUBLE_EQ(signedArea(reversed(square(0, 0, 10))), -100);
}

TEST(Footprint, PointOnASharedEdgeIsInExactlyOne) {
    const Footprint west{square(0, 0, 10), {}};
    const Footprint east{square(10, 0, 10), {}};
    const Footprint north{square(0, 10, 10), {}};
    EXPECT_FALSE(contains(west, {10, 5}));
    EXPECT_TRUE(contains(east, {10, 5}));
    EXPECT_FALSE(contains(west, {5, 10}));
    EXPECT_TRUE(contains(north, {5, 10}));
}

TEST(Footprint, HoleIsOutside) {
    const Footprint court{square(0, 0, 10), {reversed(square(4, 4, 2))}};
    EXPECT_FALSE(contains(court, {5, 5}));
    EXPECT_TRUE(contains(court, {1, 1}));
}

TEST(Rasterize, AgreesWithContainsOnEveryCell) {
    const Footprint court{{{0.5F, 0.5F}, {20.5F, 3.25F}, {17, 18.5F}, {9, 9.5F}, {2.5F, 19}},
                          {reversed(square(5.5F, 4.5F, 2))}};
    const Grid grid{-3, -2, 1, 30, 25};
    std::vector<int> filled(grid.size());
    forEachRun(court, grid, [&](int row, int first, int end) {
        for (int column = first; column < end; ++column) ++filled[grid.index(column, row)];
    });
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            EXPECT_EQ(filled[grid.index(column, row)], contains(court, grid.centre(column, row)) ? 1 : 0)
                << column << ' ' << row;
}

TEST(Triangulate, CoversTheFootprintOnce) {
    const Footprint court{square(0, 0, 10), {reversed(square(2, 2, 3))}};
    const Triangulation triangulation = triangulate(court);
    double sum = 0;
    for (const glm::uvec3 t : triangulation.triangles)
        sum += signedArea({triangulation.points[t.x], triangulation.points[t.y], triangulation.points[t.z]});
    EXPECT_NEAR(sum, area(court), 1e-4);
}

TEST(Extrude, IsClosedAndOriented) {
    const Part part{.footprint = {square(0, 0, 10), {reversed(square(2, 2, 3))}}, .bottomM = 1, .topM = 5};
    const TriangleMesh mesh = meshOf(part);
    double volume = 0;
    glm::dvec3 closure{};
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec3 normal{(b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y),
                                (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z),
                                (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)};
        closure += normal;
        volume += (a.x * normal.x + a.y * normal.y + a.z * normal.z) / 6;
    }
    EXPECT_NEAR(volume, 91 * 4, 1e-3);  // a positive volume means outward normals
    EXPECT_NEAR(closure.x, 0, 1e-6);
    EXPECT_NEAR(closure.y, 0, 1e-6);
    EXPECT_NEAR(closure.z, 0, 1e-6);
}

}  // namespace
}  // namespace noonmark
