#include "core/engines/projected/casters/shadow_casters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using Edges = std::map<std::pair<std::pair<float, float>, std::pair<float, float>>, int>;

void count(Edges& edges, glm::vec2 a, glm::vec2 b) { ++edges[{{a.x, a.y}, {b.x, b.y}}]; }

Edges edgesOf(const Footprint& footprint) {
    Edges edges;
    std::vector<Ring> rings = footprint.holes;
    rings.push_back(footprint.outer);
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) count(edges, ring[i], ring[(i + 1) % ring.size()]);
    return edges;
}

// Pieces are convex and inside the footprint, and all their edges except the last belong to the footprint.
void expectSound(const Footprint& footprint, const std::vector<Ring>& pieces, std::size_t maximum) {
    Edges edges;
    for (const Ring& piece : pieces) {
        ASSERT_LE(piece.size(), maximum);
        glm::vec2 middle(0);
        for (std::size_t i = 0; i < piece.size(); ++i) {
            if (i + 1 < piece.size()) count(edges, piece[i], piece[i + 1]);
            const glm::vec2 a = piece[i], b = piece[(i + 1) % piece.size()],
                            c = piece[(i + 2) % piece.size()];
            const glm::dvec2 u(b - a), v(c - b);
            EXPECT_TRUE(piece.size() == 2 || u.x * v.y - u.y * v.x >= -1e-4);
            middle += a / float(piece.size());
        }
        if (piece.size() < 3) continue;
        for (std::size_t i = 0; i < piece.size(); ++i)  // slightly inside each edge, even the chord
            EXPECT_TRUE(contains(
                footprint, glm::dvec2(0.01F * middle +
                                      0.99F * (0.5F * piece[i] + 0.5F * piece[(i + 1) % piece.size()]))));
    }
    EXPECT_EQ(edges, edgesOf(footprint));
}

TEST(ConvexPieces, OnlyAFootprintWithoutHolesAndRightTurnsIsConvex) {
    const Ring court = rectangle(10, 10, 20, 20);
    EXPECT_TRUE(isConvex({rectangle(0, 0, 30, 30), {}}));
    EXPECT_TRUE(isConvex({{{0, 0}, {15, 0}, {30, 0}, {30, 30}, {0, 30}}, {}}))
        << "a point on a straight wall";
    EXPECT_FALSE(isConvex({rectangle(0, 0, 30, 30), {Ring(court.rbegin(), court.rend())}}));
    EXPECT_FALSE(isConvex({{{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}}, {}}));
    EXPECT_FALSE(isConvex({{{10, 10}, {10, 20}, {0, 20}, {0, 0}, {20, 0}, {20, 10}}, {}}))
        << "its right turn is the first corner";
}

TEST(ConvexPieces, AnLIsTwoAndACourtKeepsItsWalls) {
    const Footprint angle{{{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}}, {}};
    EXPECT_EQ(splitIntoConvexPieces(angle, 60).size(), 2U);
    expectSound(angle, splitIntoConvexPieces(angle, 60), 60);
    const Ring court = rectangle(10, 10, 20, 22);
    const Footprint yard{rectangle(0, 0, 30, 30), {Ring(court.rbegin(), court.rend())}};
    const auto pieces = splitIntoConvexPieces(yard, 60);
    expectSound(yard, pieces, 60);
    for (const Ring& piece : pieces) EXPECT_LE(piece.size(), 3U);  // larger: would contain the court
}

TEST(ConvexPieces, OfRandomStarsTakeEveryEdgeOnceAndStayInside) {
    std::mt19937 random(4);
    for (int round = 0; round < 300; ++round) {
        Footprint star;
        const int points = 5 + int(random() % 90);
        for (int i = 0; i < points; ++i) {
            const double angle = 2 * std::numbers::pi * i / points;
            const double radius = round % 3 == 0 && random() % 4 != 0 ? 40 : 15 + double(random() % 25);
            star.outer.emplace_back(float(radius * std::cos(angle)), float(radius * std::sin(angle)));
        }
        if (round % 2 == 0) star.holes.push_back({{-3, -3}, {-3, 4}, {5, 4}, {5, -3}});
        const std::size_t maximum = round % 5 == 0 ? 7 : 60;
        const auto pieces = splitIntoConvexPieces(star, maximum);
        expectSound(star, pieces, maximum);
        EXPECT_LT(pieces.size(), std::size_t(points) + 4);
    }
}

}  // namespace
}  // namespace noonmark
