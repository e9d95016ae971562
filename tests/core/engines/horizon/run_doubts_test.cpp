#include "core/engines/horizon/counting/run_decider.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace noonmark {
namespace {

constexpr double binDeg = 0.25;

double azimuthOf(std::size_t bin) { return (double(bin) + 0.5) * binDeg * std::numbers::pi / 180; }

BinnedSun binsFromNorth(std::size_t count) {
    BinnedSun binned;
    for (std::size_t bin = 0; bin < count; ++bin)
        binned.bins.push_back(
            {std::uint32_t(bin), {-std::sin(azimuthOf(bin)), -std::cos(azimuthOf(bin))}, {0}});
    return binned;
}

/// The horizon of a wall from west to east, `distanceM` north of the receiver.
HorizonCode wallAt(std::size_t bin, double distanceM, double heightM) {
    const double tan = heightM / distanceM * std::cos(azimuthOf(bin));
    return toHorizonCode(float(tan / (1 + tan)));
}

// In lane 0 one wall; in lane 1 a second one of the same height, 2 cm farther, from bin 20 on; in lane 2
// light at bin 10.
std::vector<RunLanes> wallsOf(std::size_t count) {
    std::vector<RunLanes> horizons(count);
    for (std::size_t bin = 0; bin < count; ++bin) {
        horizons[bin].values[3] = noHorizon;
        horizons[bin].values[0] = wallAt(bin, 30, 40);
        horizons[bin].values[1] = wallAt(bin, bin < 20 ? 30 : 30.02, 40);
        horizons[bin].values[2] = bin == 10 ? noHorizon : wallAt(bin, 30, 40);
    }
    return horizons;
}

TEST(RunDoubts, AreWhereAnEdgeEndsAndNoneWithinIt) {
    const BinnedSun binned = binsFromNorth(40);
    const std::vector<RunLanes> horizons = wallsOf(40);
    RunDoubts::Horizons widened;
    RunDoubts(binned, 1).widen(horizons, horizons, widened);
    for (std::size_t bin = 1; bin < 39; ++bin) {
        EXPECT_GT(widened.lowest[bin].values[0], noHorizon) << bin;
        EXPECT_EQ(widened.lowest[bin].values[1] == noHorizon, bin == 19 || bin == 20) << bin;
        EXPECT_EQ(widened.lowest[bin].values[2] == noHorizon, bin >= 9 && bin <= 11) << bin;
        EXPECT_GE(widened.highest[bin].values[2], wallAt(bin, 30, 40)) << bin;
    }
    EXPECT_EQ(widened.lowest[0].values[0], noHorizon) << "nobody has seen what lies before the first bin";
}

TEST(RunDoubts, AreOfLightTooWhereOneStepMayPartARun) {
    const BinnedSun binned = binsFromNorth(40);
    const std::vector<RunLanes> horizons = wallsOf(40);
    RunDoubts::Horizons widened;
    RunDoubts(binned, 10).widen(horizons, horizons, widened);
    for (std::size_t bin = 1; bin < 39; ++bin)
        EXPECT_EQ(widened.highest[bin].values[1] == everyHorizon, bin == 19 || bin == 20) << bin;
    EXPECT_EQ(widened.highest[5].values[3], noHorizon) << "the open sky is lit";
}

TEST(RunDoubts, BelowOverhangsReachUpToTheirTop) {
    const BinnedSun binned = binsFromNorth(5);
    const std::vector<RunLanes> horizons = wallsOf(5);
    std::vector<RunLanes> filled = horizons;
    filled[2].values[0] = 30'000;
    RunDoubts::Horizons widened;
    RunDoubts(binned, 1).widen(horizons, filled, widened);
    EXPECT_EQ(widened.highest[1].values[0], 30'000);
    EXPECT_EQ(widened.highest[3].values[0], 30'000);
    EXPECT_LT(widened.highest[4].values[0], 30'000);
    EXPECT_LT(widened.lowest[2].values[0], 30'000);
}

// A part of 45 m, 30 m away in the direction of bin 20, with open air below.
TEST(RunDoubts, AreBelowPartsWithOpenAirUnlessSomethingHigherHides) {
    const BinnedSun binned = binsFromNorth(40);
    std::vector<RunLanes> horizons = wallsOf(40);
    for (std::size_t bin = 0; bin < 40; ++bin) horizons[bin].values[4] = wallAt(bin, 30, 90);
    const RunDoubts doubts(binned, 1);
    RunDoubts::Horizons widened;
    doubts.widen(horizons, horizons, widened);
    const double azimuth = azimuthOf(20);
    const glm::vec2 middle(glm::dvec2(std::sin(azimuth), std::cos(azimuth)) * 30.0);
    const glm::vec2 low = middle - 0.3F, high = middle + 0.3F;
    const OpenBelow open{{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}, {low, high}, 20, 45};
    doubts.doubt({&open, 1}, {{0, 0, 0}, {0, 0, 0}}, widened);
    for (const std::size_t bin : {18U, 20U, 22U}) {
        EXPECT_EQ(widened.lowest[bin].values[0], noHorizon) << bin;
        EXPECT_GT(widened.lowest[bin].values[4], noHorizon) << bin;
    }
    EXPECT_GT(widened.lowest[10].values[0], noHorizon);
    EXPECT_GT(widened.lowest[30].values[0], noHorizon);
}

}  // namespace
}  // namespace noonmark
