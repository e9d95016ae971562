#include "core/city/footprints/repair_footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/city/city.h"
#include "core/city/footprints/triangulate.h"
#include "core/city/meshes/extrude.h"
#include "core/city/meshes/surface_mesher.h"

namespace noonmark {
namespace {

RawRing randomRing(int points) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> metres(-200, 200);
    RawRing ring;
    for (int i = 0; i < points; ++i) {
        const double x = metres(random);
        ring.emplace_back(x, metres(random));
    }
    return ring;
}

Ring inFloat(const RawRing& ring) { return {ring.begin(), ring.end()}; }

// A ring with long teeth close together.
RawRing combRing(int teeth) {
    RawRing ring{{0, 0}};
    for (int i = 0; i < teeth; ++i)
        for (const glm::dvec2 corner : {glm::dvec2(0, 1), {0, 100}, {0.05, 100}, {0.05, 1}})
            ring.push_back(glm::dvec2(i * 0.1, 0) + corner);
    ring.emplace_back(teeth * 0.1, 0);
    return ring;
}

Ring starRing(int points) {
    Ring ring;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        const double radius = 400 + 100 * (i % 2);
        ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return ring;
}

RawRing turned(RawRing ring) {
    for (glm::dvec2& point : ring) point = {point.y, point.x};
    return ring;
}

TEST(TangledRings, RandomPointsAreAndCombsAreNot) {
    EXPECT_FALSE(areTangled({randomRing(50)}));  // 50 * 47 / 2 pairs of sides at most
    EXPECT_TRUE(areTangled({randomRing(800)}));
    EXPECT_TRUE(areTangled({randomRing(50000)}));
    EXPECT_FALSE(areTangled({combRing(12500)}));
    EXPECT_FALSE(areTangled({turned(combRing(12500))}));
}

// k bars across k bars, each a separate ring: k x k times four crossings.
TEST(TangledRings, CrossingsAreCounted) {
    const auto bars = [](int count) {
        std::vector<RawRing> rings;
        for (int i = 0; i < count; ++i) {
            const double at = i * 2.0;
            rings.push_back({{at, -1}, {at + 1, -1}, {at + 1, 1000}, {at, 1000}});
            rings.push_back({{-1.5, at}, {999, at}, {999, at + 1}, {-1.5, at + 1}});
        }
        return rings;
    };
    EXPECT_FALSE(areTangled(bars(22)));  // 1936
    EXPECT_TRUE(areTangled(bars(23)));   // 2116
}

TEST(TangledRings, AreDroppedWithTheLimitStated) {
    const RepairedFootprint repaired = repairFootprint({randomRing(3000)});
    EXPECT_TRUE(repaired.pieces.empty());
    EXPECT_EQ(repaired.kind, WarningKind::dropped);
    EXPECT_NE(repaired.what.find("more than 2000 times"), std::string::npos) << repaired.what;
    EXPECT_FALSE(repairFootprint({randomRing(60)}).pieces.empty());
}

// The triangles' areas add up to the footprint's, all have the same orientation, and there are v + 2 h - 2.
void expectTriangulated(const Footprint& footprint) {
    const Triangulation made = triangulate(footprint);
    std::size_t points = footprint.outer.size();
    for (const Ring& hole : footprint.holes) points += hole.size();
    EXPECT_EQ(made.triangles.size(), points + 2 * footprint.holes.size() - 2);
    ASSERT_EQ(made.points.size(), points);
    EXPECT_TRUE(std::equal(footprint.outer.begin(), footprint.outer.end(), made.points.begin()));
    double sum = 0;
    for (const glm::uvec3 t : made.triangles) {
        const double one = signedArea({made.points[t.x], made.points[t.y], made.points[t.z]});
        EXPECT_GE(one, 0);
        sum += one;
    }
    EXPECT_NEAR(sum, area(footprint), 1e-6 * area(footprint));
}

TEST(Triangulated, LargeRingsAndManyHoles) {
    expectTriangulated({starRing(50000), {}});
    expectTriangulated({starRing(200), {}});  // the largest ring that is inserted in its own order
    expectTriangulated({starRing(202), {}});
    Footprint grid{{{-1, -1}, {200, -1}, {200, 200}, {-1, 200}}, {}};
    for (float x = 0; x < 190; x += 3)
        for (float y = 0; y < 190; y += 3)
            grid.holes.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
    expectTriangulated(grid);
}

TEST(Triangulated, WhatCrossesItselfTooOftenIsRefused) {
    const Triangulation made = triangulate({inFloat(randomRing(3000)), {}});
    EXPECT_TRUE(made.tangled);
    EXPECT_TRUE(made.triangles.empty());
    std::vector<glm::dvec3> points;
    Surface surface(1);
    for (const glm::dvec2 point : randomRing(3000)) {
        surface[0].push_back(std::uint32_t(points.size()));
        points.emplace_back(point, 0);
    }
    SurfaceMesher mesher(points);
    EXPECT_EQ(mesher.add(surface), SurfaceMesher::Outcome::tangled);
    EXPECT_TRUE(mesher.mesh().triangles.empty());
}

TEST(TriangleCount, IsThatOfTheMesh) {
    Part part{.footprint = {starRing(60), {}}, .bottomM = 0, .topM = 10};
    EXPECT_EQ(countTriangles(part), 2U * 58 + 120);
    EXPECT_EQ(countTriangles(part), meshOf(part).triangles.size());
    // A hole in the middle; then one whose corner touches the middle of a side, and one that touches a
    // corner.
    const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    for (const Ring& hole :
         {Ring{{4, 4}, {4, 6}, {6, 6}, {6, 4}}, Ring{{5, 0}, {4, 3}, {6, 3}}, Ring{{0, 0}, {3, 4}, {4, 3}}}) {
        part.footprint = {square, {hole}};
        EXPECT_EQ(countTriangles(part), meshOf(part).triangles.size());
    }
    part.mesh = std::make_shared<const TriangleMesh>(TriangleMesh{{{}, {}, {}}, {{0, 1, 2}}});
    EXPECT_EQ(countTriangles(part), 1U);
}

}  // namespace
}  // namespace noonmark
