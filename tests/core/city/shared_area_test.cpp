#include "core/city/footprints/plan_areas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"

namespace noonmark {
namespace {

Footprint rectangle(float west, float south, float width, float height) {
    return {{{west, south}, {west + width, south}, {west + width, south + height}, {west, south + height}},
            {}};
}

double sumOf(const std::vector<Footprint>& footprints) {
    double sum = 0;
    for (const Footprint& footprint : footprints) sum += area(footprint);
    return sum;
}

// A star around a place: simple, and neither convex nor aligned.
Footprint star(std::mt19937& random) {
    std::uniform_real_distribution<float> place(0, 60), reach(5, 40);
    const glm::vec2 middle(place(random), place(random));
    const int points = 5 + int(random() % 20);
    Footprint footprint;
    for (int i = 0; i < points; ++i) {
        const float angle = 6.2831853F * float(i) / float(points), radius = reach(random);
        footprint.outer.emplace_back(middle.x + radius * std::cos(angle),
                                     middle.y + radius * std::sin(angle));
    }
    return footprint;
}

TEST(AreaShared, OfRectanglesIsWhatTheirSidesSay) {
    const Footprint square = rectangle(0, 0, 10, 10);
    EXPECT_NEAR(computeSharedArea(square, rectangle(5, 5, 10, 10)), 25, 1e-9);
    EXPECT_NEAR(computeSharedArea(square, rectangle(2, 3, 4, 5)), 20, 1e-9);
    EXPECT_NEAR(computeSharedArea(rectangle(2, 3, 4, 5), square), 20, 1e-9);
    EXPECT_NEAR(computeSharedArea(square, square), 100, 1e-9);
    EXPECT_EQ(computeSharedArea(square, rectangle(10, 0, 5, 5)), 0);
    EXPECT_EQ(computeSharedArea(square, rectangle(0, 10, 5, 5)), 0);
}

TEST(AreaShared, LeavesOutHoles) {
    Footprint yard = rectangle(0, 0, 30, 30);
    yard.holes.push_back({{10, 10}, {10, 20}, {20, 20}, {20, 10}});
    EXPECT_NEAR(computeSharedArea(yard, rectangle(0, 0, 30, 30)), 800, 1e-9);
    EXPECT_NEAR(computeSharedArea(yard, rectangle(12, 12, 5, 5)), 0, 1e-9);
    EXPECT_NEAR(computeSharedArea(rectangle(15, 15, 10, 10), yard), 75, 1e-9);
}

TEST(AreaShared, EqualsAnOverlayOfShapes) {
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        const Footprint a = star(random), b = star(random);
        EXPECT_NEAR(computeSharedArea(a, b), sumOf(cutSharedPieces({a}, {b})), 0.011) << round;
    }
}

TEST(AreaShared, KeepsItsAccuracyFarFromTheOrigin) {
    const Footprint far = rectangle(8000, -9000, 100, 50);
    EXPECT_NEAR(computeSharedArea(far, rectangle(8050, -9000, 100, 25)), 1250, 1e-6);
}

TEST(AreaOutside, LiesWithinItsBounds) {
    std::mt19937 random(5);
    for (int round = 0; round < 100; ++round) {
        const Footprint whole = star(random);
        const std::vector<Footprint> others{star(random), star(random), star(random)};
        const OutsideArea bound = boundAreaOutside({whole}, others);
        const double outside = computeAreaOutside(whole, others);
        EXPECT_LE(bound.minM2, outside + 0.05) << round;
        EXPECT_GE(bound.maxM2, outside - 0.05) << round;
    }
}

TEST(AreaOutside, IsExactWhereCoversAreDisjoint) {
    const OutsideArea bound = boundAreaOutside({rectangle(0, 0, 10, 10), rectangle(20, 0, 10, 10)},
                                               {rectangle(0, 0, 4, 10), rectangle(4, 0, 22, 5)});
    EXPECT_NEAR(bound.minM2, 200 - 40 - 30 - 30, 1e-9);
    EXPECT_NEAR(bound.maxM2, bound.minM2, 1e-9);
}

TEST(AreaOutside, OfShapesWithTooManyPointsIsNotBounded) {
    Footprint round;
    for (int i = 0; i < 2000; ++i)
        round.outer.emplace_back(50 * std::cos(float(i) * 0.00314159F),
                                 50 * std::sin(float(i) * 0.00314159F));
    const OutsideArea bound = boundAreaOutside({round}, {round});
    EXPECT_EQ(bound.minM2, 0);
    EXPECT_NEAR(bound.maxM2, area(round), 1e-6);
}

}  // namespace
}  // namespace noonmark
