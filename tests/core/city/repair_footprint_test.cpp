#include <gtest/gtest.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>

#include "core/city/city.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/city/footprints/triangulate.h"
#include "core/city/meshes/surface_mesher.h"
#include "tests/core/city/footprint_checks.h"
#include "tests/core/city/hostile_polygons.h"
#include "tests/core/city/winding_area.h"

namespace noonmark {

namespace {

using namespace tests;

RawRing rawSquare(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

double perimeter(const std::vector<RawRing>& rings) {
    double sum = 0;
    for (const RawRing& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            sum += glm::length(ring[i] - ring[(i + 1) % ring.size()]);
    return sum;
}

double largestCoordinate(const std::vector<RawRing>& rings) {
    double largest = 1;
    for (const RawRing& ring : rings)
        for (const glm::dvec2 p : ring) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    return largest;
}

// The area that rounding to float32 may change, plus the slivers that may be dropped.
double areaTolerance(const std::vector<RawRing>& rings) {
    return perimeter(rings) * largestCoordinate(rings) * 0x1p-23 + 0.011 * double(rings.size());
}

double totalArea(const std::vector<Footprint>& pieces) {
    double sum = 0;
    for (const Footprint& piece : pieces) sum += area(piece);
    return sum;
}

void expectGoodPieces(const std::vector<RawRing>& rings) {
    const RepairedFootprint repaired = repairFootprint(rings);
    for (const Footprint& piece : repaired.pieces) {
        EXPECT_EQ(faultOf(piece), "");
        EXPECT_EQ(faultOfSolid(piece), "");
        EXPECT_GE(area(piece), 0.01);
    }
    EXPECT_EQ(cellsSharedBy(repaired.pieces), 0);
    EXPECT_NEAR(totalArea(repaired.pieces), WindingArea(rings)(), areaTolerance(rings)) << repaired.what;
    if (repaired.pieces.empty()) {
        EXPECT_EQ(repaired.kind, WarningKind::dropped);
        EXPECT_NE(repaired.what, "");
    }
}

std::vector<RawRing> scaledAndMoved(std::vector<RawRing> rings, double sideM, glm::dvec2 to) {
    glm::dvec2 low(1e30);
    glm::dvec2 high(-1e30);
    for (const RawRing& ring : rings)
        for (const glm::dvec2 p : ring) low = glm::min(low, p), high = glm::max(high, p);
    const double scale = sideM / std::max({high.x - low.x, high.y - low.y, 1e-9});
    for (RawRing& ring : rings)
        for (glm::dvec2& p : ring) p = to + (p - low) * scale;
    return rings;
}

TEST(RepairFootprint, HostilePolygonsAsTheyAre) {
    const auto polygons = hostilePolygons();
    if (polygons.empty()) GTEST_SKIP() << "shared data is missing: hostile/earcut_polygons";
    EXPECT_EQ(polygons.size(), 59U);
    for (const auto& [name, rings] : polygons) {
        SCOPED_TRACE(name);
        expectGoodPieces(rings);
    }
}

TEST(RepairFootprint, HostilePolygonsAsBuildingsFarFromTheOrigin) {
    const auto polygons = hostilePolygons();
    if (polygons.empty()) GTEST_SKIP() << "shared data is missing: hostile/earcut_polygons";
    for (const auto& [name, rings] : polygons)
        for (const double side : {2.0, 60.0, 300.0}) {
            SCOPED_TRACE(name + ", side " + std::to_string(side));
            expectGoodPieces(scaledAndMoved(rings, side, {10003.7, -9876.5}));
        }
}

TEST(RepairFootprint, ValidPolygonsAreKeptAndOriented) {
    const auto repaired = repairFootprint({{{0, 0}, {0, 10}, {10, 10}, {10, 0}, {0, 0}}, rawSquare(2, 2, 3)});
    ASSERT_EQ(repaired.pieces.size(), 1U);
    EXPECT_EQ(repaired.what, "");
    EXPECT_DOUBLE_EQ(signedArea(repaired.pieces[0].outer), 100);
    ASSERT_EQ(repaired.pieces[0].holes.size(), 1U);
    EXPECT_DOUBLE_EQ(signedArea(repaired.pieces[0].holes[0]), -9);
}

TEST(RepairFootprint, CrossedOutlineBecomesItsTwoLobes) {
    const auto repaired = repairFootprint({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}});
    EXPECT_EQ(repaired.pieces.size(), 2U);
    EXPECT_DOUBLE_EQ(totalArea(repaired.pieces), 50);
    EXPECT_EQ(repaired.kind, WarningKind::repaired);
    EXPECT_EQ(repaired.what, "outline or holes crossed");
}

TEST(RepairFootprint, HoleOutsideBecomesAPieceAndIsReported) {
    const auto repaired = repairFootprint({rawSquare(0, 0, 10), rawSquare(20, 0, 5)});
    EXPECT_EQ(repaired.pieces.size(), 2U);
    EXPECT_DOUBLE_EQ(totalArea(repaired.pieces), 125);
    EXPECT_EQ(repaired.what, "a hole lay outside its outline");
}

TEST(RepairFootprint, HoleThatSticksOutCutsOnlyTheInside) {
    const auto repaired = repairFootprint({rawSquare(0, 0, 10), rawSquare(8, 2, 5)});
    ASSERT_EQ(repaired.pieces.size(), 1U);
    EXPECT_DOUBLE_EQ(totalArea(repaired.pieces), 90);
}

TEST(RepairFootprint, NothingUsableGivesNoPiecesAndAReason) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<std::vector<RawRing>> useless{
        {},
        {{}},
        {{{1, 1}}},
        {{{1, 1}, {2, 2}}},
        {{{1, 1}, {1, 1}, {1, 1}, {1, 1}}},
        {{{0, 0}, {5, 5}, {10, 10}}},
        {rawSquare(0, 0, 0.05)},
        {rawSquare(0, 0, 10), rawSquare(0, 0, 10)},
        {{{0, 0}, {nan, 1}, {1, 1}}},
        {{{0, 0}, {inf, 1}, {1, 1}}},
        {{{0, 0}, {1e300, 1}, {1, 1}}},
        {{}, rawSquare(0, 0, 10)},
    };
    for (const auto& rings : useless) {
        const auto repaired = repairFootprint(rings);
        EXPECT_TRUE(repaired.pieces.empty());
        EXPECT_EQ(repaired.kind, WarningKind::dropped);
        EXPECT_NE(repaired.what, "");
    }
}

TEST(RepairFootprint, HolesThatAreNoneAreLeftOutAndReported) {
    const auto repaired = repairFootprint({rawSquare(0, 0, 10), {{1, 1}, {2, 2}}});
    ASSERT_EQ(repaired.pieces.size(), 1U);
    EXPECT_TRUE(repaired.pieces[0].holes.empty());
    EXPECT_EQ(repaired.what, "a hole had fewer than three points");
}

TEST(RepairFootprint, PointsThatFallTogetherInFloatAreMerged) {
    // At 10 km float32 steps are 1 mm: the first two points coincide, and the slit has no width.
    const auto repaired = repairFootprint({{{10000, 0},
                                            {10000.0001, 0},
                                            {10010, 0},
                                            {10010, 10},
                                            {10005.0002, 10},
                                            {10005.0001, 9},
                                            {10005, 10},
                                            {10000, 10}}});
    ASSERT_EQ(repaired.pieces.size(), 1U);
    EXPECT_EQ(faultOf(repaired.pieces[0]), "");
    EXPECT_LE(repaired.pieces[0].outer.size(), 5U);
    EXPECT_NEAR(area(repaired.pieces[0]), 100, 0.01);
}

TEST(RepairFootprint, SharedPointsOfNeighboursStayShared) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-12000, 12000);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec2 a{place(random), place(random)};
        const glm::dvec2 b = a + glm::dvec2{3.3, 17.7};
        const auto west = repairFootprint({{a, b, a + glm::dvec2{-20, 5}}}).pieces;
        const auto east = repairFootprint({{a, b, a + glm::dvec2{20, 5}}}).pieces;
        ASSERT_EQ(west.size() + east.size(), 2U);
        for (const glm::vec2 shared : {glm::vec2(a), glm::vec2(b)})
            for (const Ring& ring : {west[0].outer, east[0].outer})
                EXPECT_NE(std::find(ring.begin(), ring.end(), shared), ring.end());
    }
}

// Random scribbles contain every kind of crossing.
TEST(RepairFootprint, RandomScribbles) {
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i) {
        std::vector<RawRing> rings(1 + random() % 3);
        const double grid = i % 2 == 0 ? 1.0 : 0.37;  // on whole metres many points lie on edges
        const glm::dvec2 origin = i % 3 == 0 ? glm::dvec2{9000.3, -8000.7} : glm::dvec2{};
        for (RawRing& ring : rings) {
            ring.resize(3 + random() % 12);
            for (glm::dvec2& p : ring)
                p = origin + grid * glm::dvec2{double(random() % 30), double(random() % 30)};
        }
        SCOPED_TRACE(i);
        expectGoodPieces(rings);
    }
}

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
    const Ring rawSquare{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    for (const Ring& hole :
         {Ring{{4, 4}, {4, 6}, {6, 6}, {6, 4}}, Ring{{5, 0}, {4, 3}, {6, 3}}, Ring{{0, 0}, {3, 4}, {4, 3}}}) {
        part.footprint = {rawSquare, {hole}};
        EXPECT_EQ(countTriangles(part), meshOf(part).triangles.size());
    }
    part.mesh = std::make_shared<const TriangleMesh>(TriangleMesh{{{}, {}, {}}, {{0, 1, 2}}});
    EXPECT_EQ(countTriangles(part), 1U);
}

}  // namespace

}  // namespace noonmark
