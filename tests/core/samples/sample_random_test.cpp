#include "core/samples/lot_building.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace noonmark {
namespace {

TEST(SampleRandom, FunctionsAreTrueToTwelveDigits) {
    for (double x = -20; x <= 20; x += 0.037) EXPECT_NEAR(portableExp(x) / std::exp(x), 1, 1e-12) << x;
    for (double turns = -1; turns <= 1; turns += 0.0013) {
        EXPECT_NEAR(portableSineCosine(turns).sine, std::sin(2 * std::numbers::pi * turns), 1e-12) << turns;
        EXPECT_NEAR(portableSineCosine(turns).cosine, std::cos(2 * std::numbers::pi * turns), 1e-12) << turns;
    }
}

TEST(SampleRandom, StreamsAreTheirOwn) {
    EXPECT_EQ(SampleRandom(1, 2, 3).uniform(), SampleRandom(1, 2, 3).uniform());
    EXPECT_NE(SampleRandom(1, 2, 3).uniform(), SampleRandom(1, 3, 2).uniform());
    EXPECT_NE(SampleRandom(1, 2, 3).uniform(), SampleRandom(2, 2, 3).uniform());
}

TEST(SampleRandom, LogNormalHasItsMedianAndSpread) {
    SampleRandom random(5, 0, 0);
    std::vector<double> values(20001);
    for (double& value : values) value = random.logNormal(20, 0.45);
    std::sort(values.begin(), values.end());
    EXPECT_NEAR(values[10000], 20, 0.3);
    EXPECT_NEAR(std::log(values[16826] / values[10000]), 0.45, 0.02);  // one sigma: 84.13 %
}

}  // namespace
}  // namespace noonmark
