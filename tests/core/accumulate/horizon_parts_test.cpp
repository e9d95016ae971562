#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/accumulate/horizon/azimuth_bins.h"
#include "core/accumulate/horizon/longest_runs.h"
#include "core/accumulate/horizon/sheared_tile.h"
#include "tests/core/accumulate/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

TEST(AzimuthBin, countsTheStepsBelowASlope) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> logarithm(-4, 4);
    for (int round = 0; round < 50; ++round) {
        std::vector<float> tans;
        for (int i = 0; i < 1 + round * 7; ++i) tans.push_back(float(std::pow(10.0, logarithm(random))));
        if (round % 2 == 0) tans.push_back(tans.front());
        std::ranges::sort(tans);
        const AzimuthBin bin({0, 1}, tans);
        for (int i = 0; i < 500; ++i) {
            float slope =
                i % 3 == 0 ? tans[std::size_t(i) % tans.size()] : float(std::pow(10.0, logarithm(random)));
            if (i % 5 == 0) slope = std::nextafter(slope, 1e9F);
            EXPECT_EQ(bin.hidden(slope), std::ranges::count_if(tans, [&](float tan) { return tan < slope; }));
        }
        EXPECT_EQ(bin.hidden(0), 0);
    }
}

TEST(BinnedSun, everyStepHasItsRankInABinOfItsAzimuth) {
    SunSteps sun = oneDay(arc(700, 60));
    addDay(sun, arc(700, 30, true));
    const BinnedSun binned = binnedSun(sun, 0.5);
    std::size_t steps = 0;
    for (const AzimuthBin& bin : binned.bins) {
        EXPECT_TRUE(std::ranges::is_sorted(bin.tans()));
        steps += bin.tans().size();
    }
    EXPECT_EQ(steps, sun.steps.size());
    for (std::size_t i = 0; i < sun.steps.size(); ++i) {
        const AzimuthBin& bin = binned.bins[binned.places[i].bin];
        const glm::dvec3 towards(sun.steps[i].direction);
        const double level = std::hypot(towards.x, towards.y);
        EXPECT_NEAR(double(bin.tans()[std::size_t(binned.places[i].rank)]) * level / towards.z, 1, 1e-5);
        EXPECT_GT(-(bin.away().x * towards.x + bin.away().y * towards.y) / level, std::cos(0.5 / 57.2957));
    }
}

TEST(BinnedSun, fullBinsAreCutInTwo) {
    const BinnedSun binned = binnedSun(oneDay(std::vector<Sun>(70'000, {180.2, 30})), 0.5);
    ASSERT_EQ(binned.bins.size(), 3U);
    for (const AzimuthBin& bin : binned.bins) EXPECT_LE(bin.tans().size(), BinnedSun::mostStepsABin);
}

TEST(LongestRuns, areThoseOfAStepByStepWalk) {
    std::mt19937 random(5);
    std::vector<BlockRanks> ranks(40);
    for (BlockRanks& bin : ranks)
        for (std::int16_t& rank : bin.values) rank = std::int16_t(random() % 20);
    std::vector<TimedStep> steps;
    for (int i = 0; i < 3000; ++i)
        steps.push_back(
            {{std::uint16_t(i % 200 / 5), std::int16_t(random() % 20)}, i % 200 == 0 || i == 777});
    const BlockRanks longest = longestRuns(ranks, steps);
    for (std::size_t receiver = 0; receiver < receiversABlock; ++receiver) {
        int run = 0, expected = 0;
        for (const TimedStep& step : steps) {
            if (step.startsRun) run = 0;
            run = step.place.rank < ranks[step.place.bin].values[receiver] ? run + 1 : 0;
            expected = std::max(expected, run);
        }
        EXPECT_EQ(longest.values[receiver], expected) << receiver;
    }
}

TEST(ShearedTile, aLineHasTheCellsThatItsShadowsMeet) {
    const TileBox box{3, 5, 37, 23};
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const double azimuth = degrees / 57.29577951308232;
        const ShearedTile tile(box, {std::sin(azimuth), std::cos(azimuth)});
        std::size_t cells = 0;
        for (int line = 0; line < tile.lines(); ++line)
            for (int along = 0; along < tile.length(); ++along) {
                const int across = tile.across(line, along);
                const bool inside = across >= 0 && across < tile.width();
                EXPECT_EQ(inside, along >= tile.first(line) && along < tile.end(line)) << degrees;
                if (!inside) continue;
                ++cells;
                const int row = tile.rowAt(along);
                const glm::dvec2 centre = tile.swapped()
                                              ? glm::dvec2(box.firstColumn + row, box.firstRow + across)
                                              : glm::dvec2(box.firstColumn + across, box.firstRow + row);
                const ShearedTile::Point point = tile.from(centre);
                EXPECT_EQ(int(std::lround(point.along)), along);
                EXPECT_NEAR(point.q, line + double(tile.fractions()[along]), 1e-5);
            }
        EXPECT_EQ(cells, std::size_t(box.columns * box.rows)) << degrees;
    }
}

}  // namespace
}  // namespace noonmark
