#include "core/city/footprints/repair_footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "core/city/city.h"
#include "tests/core/city/footprint_checks.h"
#include "tests/core/city/hostile_polygons.h"
#include "tests/core/city/winding_area.h"

namespace noonmark {
namespace {

using namespace tests;

RawRing square(double x, double y, double side) {
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
        EXPECT_EQ(troubleOf(piece), "");
        EXPECT_EQ(troubleOfSolid(piece), "");
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
    const auto repaired = repairFootprint({{{0, 0}, {0, 10}, {10, 10}, {10, 0}, {0, 0}}, square(2, 2, 3)});
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

TEST(RepairFootprint, HoleOutsideBecomesAPieceAndIsSaid) {
    const auto repaired = repairFootprint({square(0, 0, 10), square(20, 0, 5)});
    EXPECT_EQ(repaired.pieces.size(), 2U);
    EXPECT_DOUBLE_EQ(totalArea(repaired.pieces), 125);
    EXPECT_EQ(repaired.what, "a hole lay outside its outline");
}

TEST(RepairFootprint, HoleThatSticksOutCutsOnlyTheInside) {
    const auto repaired = repairFootprint({square(0, 0, 10), square(8, 2, 5)});
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
        {square(0, 0, 0.05)},
        {square(0, 0, 10), square(0, 0, 10)},
        {{{0, 0}, {nan, 1}, {1, 1}}},
        {{{0, 0}, {inf, 1}, {1, 1}}},
        {{{0, 0}, {1e300, 1}, {1, 1}}},
        {{}, square(0, 0, 10)},
    };
    for (const auto& rings : useless) {
        const auto repaired = repairFootprint(rings);
        EXPECT_TRUE(repaired.pieces.empty());
        EXPECT_EQ(repaired.kind, WarningKind::dropped);
        EXPECT_NE(repaired.what, "");
    }
}

TEST(RepairFootprint, HolesThatAreNoneAreLeftOutAndSaid) {
    const auto repaired = repairFootprint({square(0, 0, 10), {{1, 1}, {2, 2}}});
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
    EXPECT_EQ(troubleOf(repaired.pieces[0]), "");
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

}  // namespace
}  // namespace noonmark
