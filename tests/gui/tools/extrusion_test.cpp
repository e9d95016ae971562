#include "app/gui/tools/preview/edit_context.h"

#include <gtest/gtest.h>

#include <random>

namespace noonmark {
namespace {

const ViewLens viewLens{40, 1200, 800};

TEST(Extrusion, APointOfTheVerticalIsFoundThroughItsPixel) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-200, 200), heading(0, 360), pitch(3, 75), height(0, 300);
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 foot{place(random), place(random), 12};
        const CameraPose pose{{0, 0, 0}, 1500, heading(random), pitch(random)};
        const double wanted = height(random);
        const auto pixel = pixelOf(pose, viewLens, foot + glm::dvec3(0, 0, wanted));
        ASSERT_TRUE(pixel);
        const auto found = heightOnVertical(makeRayThrough(pose, viewLens, *pixel), foot);
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, wanted, 1e-6);
    }
}

TEST(Extrusion, BesideTheVerticalItIsTheNearestPoint) {
    const ViewRay ray{{0, -100, 50}, {0, 1, 0}};
    EXPECT_NEAR(heightOnVertical(ray, {7, 30, 20}).value(), 30, 1e-9);
}

TEST(Extrusion, NearlyVerticalRaysAndThoseThatLeadAwaySayNothing) {
    EXPECT_FALSE(heightOnVertical({{0, 0, 500}, {0, 0, -1}}, {3, 4, 0}));
    EXPECT_FALSE(heightOnVertical({{0, -100, 50}, {0, -1, 0}}, {0, 0, 0}));
}

TEST(Extrusion, HeightsSnapToStoreysWithinTheRange) {
    EXPECT_DOUBLE_EQ(roundToStoreys(36.2, 3.5), 35);
    EXPECT_DOUBLE_EQ(roundToStoreys(36.8, 3.5), 38.5);
    EXPECT_DOUBLE_EQ(roundToStoreys(-20, 3.5), 3.5) << "one storey at least";
    EXPECT_LE(roundToStoreys(1e6, 3.5), 2000);
    EXPECT_DOUBLE_EQ(roundToStoreys(1e6, 4), 2000);
    EXPECT_DOUBLE_EQ(roundHeight(36.24, 3.5), 36.2);
    EXPECT_DOUBLE_EQ(roundHeight(1, 3.5), 3.5);
    EXPECT_DOUBLE_EQ(roundHeight(5000, 3.5), 2000);
}

}  // namespace
}  // namespace noonmark
