#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "core/engines/common/run_counter.h"
#include "core/engines/points/horizons/horizon_of_point.h"
#include "core/engines/points/horizons/sun_track.h"
#include "tests/core/engines/points/random_horizon.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/simd/random_blocks.h"

namespace noonmark {
namespace {

using namespace tests;

TEST(RunCounter, CountsAsStepByStep) {
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        RunCounter runs;
        std::uint32_t total = 0, run = 0, longest = 0;
        for (int packet = 0; packet < 6; ++packet) {
            const int count = 1 + int(random() % 32);
            const auto all = std::uint32_t((1ULL << unsigned(count)) - 1);
            const std::uint32_t shadow = random() % 3 == 0 ? all : std::uint32_t(random() | random()) & all;
            const std::uint32_t starts =
                random() % 2 == 0 ? 0U : std::uint32_t(random() & random() & random()) & all;
            runs.add(shadow, starts, count);
            for (int k = 0; k < count; ++k) {
                if ((starts >> unsigned(k) & 1U) != 0) run = 0;
                run = (shadow >> unsigned(k) & 1U) != 0 ? run + 1 : 0;
                total += run > 0 ? 1 : 0;
                longest = std::max(longest, run);
            }
        }
        EXPECT_EQ(runs.total(), total);
        EXPECT_EQ(runs.longest(), longest);
    }
}

TEST(CountSuns, CountsAsStepByStep) {
    SunSteps sun = days(47, 60, 3);
    numberDays(sun);
    const SunBins bins(sun);
    for (std::uint32_t seed = 1; seed < 12; ++seed) {
        const BinHorizon horizon = randomHorizon(seed);
        SunBins::Months months{};
        for (const SunDay& day : sun.days)
            for (std::uint32_t i = day.first; i < day.first + day.count; ++i)
                if (!horizon.hides(binSun(sun.steps[i]))) ++months[unsigned(day.date.month()) - 1];
        forEachInstructionSet([&] { EXPECT_EQ(countSunlit(bins, horizon), months) << seed; });
    }
}

TEST(RangeBounds, HoldTheBinsOfEveryWindow) {
    const BinHorizon horizon = randomHorizon(5);
    const RangeBounds bounds(horizon);
    std::mt19937 random(3);
    for (int round = 0; round < 2000; ++round) {
        const int first = int(random() % SunBins::count), count = 1 + int(random() % 300);
        const auto window = std::size_t(BinRanges::around(first, count));
        for (int bin = first; bin < first + count; ++bin) {
            const auto k = std::size_t(bin % SunBins::count);
            ASSERT_LE(bounds.low[window], horizon.tan[k]);
            ASSERT_GE(bounds.high[window], horizon.topTan(k));
        }
    }
}

// Blocks and towers, some of which hang in the air, around points on the ground and on walls.
TEST(HorizonOfPoint, IsTheSameOnEveryInstructionSet) {
    SunSteps sun = days(47, 20, 3);
    numberDays(sun);
    for (std::uint32_t seed = 1; seed < 4; ++seed) {
        const auto boxes = randomBoxes(seed, 8);
        const HorizonScene scene(cityOf(boxes), sun, true);
        std::mt19937 random(seed);
        for (int i = 0; i < 40; ++i) {
            const glm::vec3 place(anyFrom(random, -150, 150), anyFrom(random, -150, 150),
                                  anyFrom(random, 0, 30));
            const float turn = anyFrom(random, 0, 6.28F);
            const glm::vec3 normal = i % 3 == 0   ? glm::vec3(0, 0, 1)
                                     : i % 3 == 1 ? glm::vec3(std::sin(turn), std::cos(turn), 0)
                                                  : glm::vec3(0, 0, -1);
            std::optional<SunBins::Months> months;
            std::optional<PointRuns> runs;
            forEachInstructionSet([&] {
                HorizonOfPoint horizon(scene);
                horizon.sweep(place, normal);
                if (!months) months = horizon.countSunlit(), runs = horizon.countRuns();
                EXPECT_EQ(horizon.countSunlit(), *months);
                EXPECT_EQ(horizon.countRuns(), *runs);
            });
        }
    }
}

}  // namespace
}  // namespace noonmark
