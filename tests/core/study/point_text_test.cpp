#include "core/study/text/point_text.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

TEST(SkylineWidths, OfAWallCountInFrontOfIt) {
    // The wall faces south: it sees azimuths from 90 to 270 degrees.
    PointView view;
    view.stretches = {{170, 190, 0}, {80, 100, 1}, {350, 10, 2}, {260, 100, 3}};
    const auto wall = skylineWidthsDeg(view, 180);
    EXPECT_NEAR(wall.at(0), 20, 1e-9);
    EXPECT_NEAR(wall.at(1), 10, 1e-9);
    EXPECT_EQ(wall.count(2), 0U);
    EXPECT_NEAR(wall.at(3), 20, 1e-9) << "10 degrees at either side";
    const auto level = skylineWidthsDeg(view, {});
    EXPECT_NEAR(level.at(2), 20, 1e-9);
    EXPECT_NEAR(level.at(3), 200, 1e-9);
}

}  // namespace
}  // namespace noonmark
