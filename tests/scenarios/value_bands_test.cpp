#include "scenarios/project/tables/layer_styles.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace noonmark::tests {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(ValueBands, MinutesFallIntoRoundBandsWithTheTopInTheLast) {
    const std::array values{0.0F, 59.9F, 60.0F, 360.0F, nan};
    const ValueBands bands(values, "min/day", false);
    ASSERT_EQ(bands.bands().size(), 6U);
    EXPECT_EQ(bands.bands()[1].label, "60 to 120 min/day");
    EXPECT_EQ(bands.bandOf(0), 0);
    EXPECT_EQ(bands.bandOf(59.9F), 0);
    EXPECT_EQ(bands.bandOf(60), 1);
    EXPECT_EQ(bands.bandOf(360), 5);
    EXPECT_EQ(bands.bandOf(nan), -1);
}

TEST(ValueBands, ChangesAreEvenOnBothSidesAndNoneIsNoBand) {
    const std::array values{-30.0F, 0.0F, 12.0F};
    const ValueBands bands(values, "min", true);
    ASSERT_EQ(bands.bands().size(), 12U);
    EXPECT_EQ(bands.bands().front().low, -30);
    EXPECT_EQ(bands.bands().back().high, 30);
    EXPECT_EQ(bands.bandOf(0), -1);
    for (const float value : {0.01F, 4.99F, 5.0F, 12.0F, 30.0F}) {
        const auto& more = bands.bands().at(std::size_t(bands.bandOf(value)));
        const auto& less = bands.bands().at(std::size_t(bands.bandOf(-value)));
        EXPECT_EQ(more.low, -less.high) << value;
        EXPECT_LE(more.low, value);
        EXPECT_GE(more.high, value);
    }
}

}  // namespace
}  // namespace noonmark::tests
