#include "core/geo/lon_lat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace noonmark {
namespace {

TEST(Distance, KnownOnTheSphere) {
    constexpr double quarterM = 6371000 * 3.14159265358979 / 2;
    EXPECT_EQ(computeGreatCircleM({-73.98, 40.75}, {-73.98, 40.75}), 0);
    EXPECT_NEAR(computeGreatCircleM({0, 0}, {90, 0}), quarterM, 1);
    EXPECT_NEAR(computeGreatCircleM({30, -90}, {-120, 90}), 2 * quarterM, 1);
    EXPECT_NEAR(computeGreatCircleM({179.9, 0}, {-179.9, 0}), quarterM * 0.2 / 90, 1);
    EXPECT_NEAR(computeGreatCircleM({-73.98, 40.75}, {106.02, -40.75}), 2 * quarterM, 1);
    EXPECT_TRUE(std::isnan(computeGreatCircleM({std::numeric_limits<double>::quiet_NaN(), 0}, {0, 0})));
}

}  // namespace
}  // namespace noonmark
