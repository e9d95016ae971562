#include "core/receivers/parcels/parcel_lines.h"

#include <gmock/gmock.h>

#include <numbers>

namespace noonmark {

namespace {

TEST(LineBelts, LieBetweenLinesAroundAParcel) {
    const Footprint parcel{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};
    const auto belt = cutBelt({parcel}, 5, 10);
    ASSERT_TRUE(belt);
    ASSERT_EQ(belt->size(), 1);
    // Four strips of 10 x 5 m, and a quarter of a ring at each corner.
    const double exact = 4 * 10 * 5 + std::numbers::pi * (10 * 10 - 5 * 5);
    EXPECT_NEAR(area(belt->front()), exact, 0.005 * exact);
    EXPECT_FALSE(contains(belt->front(), {5, -4.9}));
    EXPECT_TRUE(contains(belt->front(), {5, -5.1}));
    EXPECT_TRUE(contains(belt->front(), {5, 19.9}));
    EXPECT_FALSE(contains(belt->front(), {5, 20.1}));
    EXPECT_TRUE(contains(belt->front(), {-5.1, -5.1}));   // 7.2 m from the corner
    EXPECT_FALSE(contains(belt->front(), {-7.2, -7.2}));  // 10.2 m
}

TEST(LineBelts, SurroundParcelsThatTouch) {
    const Footprint west{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};
    const Footprint east{{{10, 0}, {20, 0}, {20, 10}, {10, 10}}, {}};
    const auto belt = cutBelt({west, east}, 0, 1);
    ASSERT_TRUE(belt);
    double sum = 0;
    for (const Footprint& polygon : *belt) sum += area(polygon);
    EXPECT_NEAR(sum, 60 + std::numbers::pi, 0.05);
}

}  // namespace

}  // namespace noonmark
