#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

TEST(HorizonCode, HidesWhatIsLowerButForHalfALevel) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> logarithm(-4, 4);
    for (int i = 0; i < 100'000; ++i) {
        const double slope = std::pow(10.0, logarithm(random)), tan = std::pow(10.0, logarithm(random));
        const bool hidden = toHorizonCode(float(slope / (1 + slope))) > toSunCode(tan);
        const double levels = steepnessLevels * (slope / (1 + slope) - tan / (1 + tan));
        if (std::abs(levels) > 0.51 && slope < 1e4) {
            EXPECT_EQ(hidden, levels > 0) << slope << ' ' << tan;
        }
    }
    EXPECT_GT(toHorizonCode(1), toSunCode(1e5));
    EXPECT_LE(toHorizonCode(1), toSunCode(1e9));
    EXPECT_LE(toHorizonCode(0), toSunCode(1e-9));
}

TEST(HiddenSuns, CountsTheSunsBelowAHorizon) {
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) {
        std::vector<HorizonCode> suns;
        for (int i = 0; i < round * 7; ++i)
            suns.push_back(HorizonCode(int(random() % 3000) - 1500 + 600 * round - 31'000));
        std::ranges::sort(suns);
        const HiddenSuns hidden(suns);
        for (int code = -32'768; code < 32'768; code += 1 + int(random() % 100))
            EXPECT_EQ(hidden(HorizonCode(code)),
                      std::ranges::count_if(suns, [&](HorizonCode sun) { return sun < code; }));
    }
}

TEST(BinnedSun, EveryStepIsInABinOfItsAzimuth) {
    SunSteps sun = oneDay(arc(700, 60));
    addDay(sun, arc(700, 30, true));
    const BinnedSun binned = binSun(sun, 0.5);
    std::size_t steps = 0;
    for (const AzimuthBin& bin : binned.bins) {
        EXPECT_TRUE(std::ranges::is_sorted(bin.suns));
        steps += bin.suns.size();
    }
    EXPECT_EQ(steps, sun.steps.size());
    for (std::size_t i = 0; i < sun.steps.size(); ++i) {
        const AzimuthBin& bin = binned.bins[binned.places[i].bin];
        const glm::dvec3 towards(sun.steps[i].direction);
        const double level = std::hypot(towards.x, towards.y);
        EXPECT_EQ(binned.places[i].sun, toSunCode(towards.z / level));
        EXPECT_TRUE(std::ranges::binary_search(bin.suns, binned.places[i].sun));
        EXPECT_GT(-(bin.away.x * towards.x + bin.away.y * towards.y) / level, std::cos(0.5 / 57.2957));
    }
}

TEST(ReceiverBlocks, NumberEveryReceiverOnce) {
    const City city = cityOf(randomBoxes(1, 4));
    const Receivers receivers = receiversOver(city, -7, -9, 90, 75);
    std::vector<int> times(receivers.grid.size());
    for (const TileBox& box : splitIntoTiles(receivers.grid, 48)) {
        const ReceiverBlocks blocks(receivers, box);
        for (std::size_t b = 0; b < blocks.blocks().size(); ++b) {
            const auto& block = blocks.blocks()[b];
            EXPECT_EQ(block.first % 32, 0U);
            for (std::uint32_t i = 0; i < block.count; ++i) {
                ++times[blocks.cell(block.first + i)];
                const int place = blocks.places(block, false)[i], turned = blocks.places(block, true)[i];
                EXPECT_EQ(receivers.grid.index(block.column + place % 16, block.row + place / 16),
                          blocks.cell(block.first + i));
                EXPECT_EQ(turned, place % 16 * 16 + place / 16);
                EXPECT_TRUE(blocks.masks(b, false)[std::size_t(place / 16)] >> (place % 16) & 1);
                EXPECT_TRUE(blocks.masks(b, true)[std::size_t(place % 16)] >> (place / 16) & 1);
            }
        }
    }
    for (std::size_t cell = 0; cell < times.size(); ++cell)
        EXPECT_EQ(times[cell], receivers.kind[cell] == CellKind::ground ? 1 : 0);
}

}  // namespace
}  // namespace noonmark
