#include "app/report/book/diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace noonmark {
namespace {

Place streetOf(Ring outline) {
    return {"Main Street", PlaceKind::street, {{std::move(outline), {}}}, "drawn"};
}

// A view of 200 x 200 m around (50, 5), two units a metre.
MapView view() { return {glm::dvec2(50, 5), 2, QRectF(0, 0, 400, 400)}; }

TEST(StreetName, LiesInTheMiddleOfTheStreet) {
    const auto spot = findStreetNameSpot(streetOf({{0, 0}, {100, 0}, {100, 10}, {0, 10}}), view());
    ASSERT_TRUE(spot);
    EXPECT_NEAR(spot->middle.x(), 200, 1e-3);
    EXPECT_NEAR(spot->middle.y(), 200, 1e-3);
    EXPECT_NEAR(spot->angleDeg, 0, 1e-6);
    EXPECT_NEAR(spot->room, 200, 1e-3);
}

TEST(StreetName, IsNeverUpsideDownWhereverTheOutlineBegins) {
    const Ring north{{45, -45}, {55, -45}, {55, 55}, {45, 55}};
    for (std::size_t first = 0; first < 4; ++first) {
        Ring ring = north;
        std::rotate(ring.begin(), ring.begin() + std::ptrdiff_t(first), ring.end());
        const auto spot = findStreetNameSpot(streetOf(ring), view());
        ASSERT_TRUE(spot);
        EXPECT_NEAR(std::abs(spot->angleDeg), 90, 1e-3);
        EXPECT_NEAR(spot->middle.x(), 200, 1e-3);
    }
    // Towards the south-east: the text falls to the right.
    const auto falling = findStreetNameSpot(streetOf({{0, 50}, {100, -50}, {107, -43}, {7, 57}}), view());
    ASSERT_TRUE(falling);
    EXPECT_NEAR(falling->angleDeg, 45, 1e-3);
}

TEST(StreetName, OnlyWhatIsSeenCounts) {
    // The view ends at x = 150: of the street from 100 to 1100, 50 m are seen.
    const auto spot = findStreetNameSpot(streetOf({{100, 0}, {1100, 0}, {1100, 10}, {100, 10}}), view());
    ASSERT_TRUE(spot);
    EXPECT_NEAR(spot->room, 100, 1e-3);
    EXPECT_NEAR(spot->middle.x(), 350, 1e-3);
    EXPECT_FALSE(findStreetNameSpot(streetOf({{500, 0}, {600, 0}, {600, 10}, {500, 10}}), view()));
}

}  // namespace
}  // namespace noonmark
