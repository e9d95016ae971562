#include "core/lab/bench/contests/site.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/core/lab/bench/tiny_site.h"

namespace noonmark::bench {
namespace {

TEST(BenchSite, SquaresLieInTheCityAndComeBackForTheSameSeed) {
    BenchSite site = tests::tinySite();
    const Box2 city = bounds(site.city);
    const auto squares = pickRandomSquares(site, 20);
    ASSERT_EQ(squares.size(), 20U);
    for (const Region& square : squares) {
        const Box2 box = bounds(square);
        EXPECT_NEAR(box.high.x - box.low.x, 60, 0.01);
        EXPECT_GE(box.low.x, city.low.x - 0.01F);
        EXPECT_LE(box.high.y, city.high.y + 0.01F);
    }
    EXPECT_EQ(squares, pickRandomSquares(site, 20));
    site.seed = 2;
    EXPECT_NE(squares, pickRandomSquares(site, 20));
}

TEST(BenchSite, ACityThatIsSmallerThanTheSquareIsTakenWhole) {
    BenchSite site = tests::tinySite();
    site.sideM = 100'000;
    const Box2 city = bounds(site.city), box = bounds(pickRandomSquares(site, 1).front());
    EXPECT_NEAR(box.low.x, city.low.x, 0.01);
    EXPECT_NEAR(box.high.y, city.high.y, 0.01);
}

TEST(BenchSite, RandomDaysAreDifferentDaysOfTheYear) {
    const auto days = pickRandomDays(tests::tinySite(), 365);
    EXPECT_EQ(days.size(), 365U);
    EXPECT_EQ(formatText(days.front()), "2026-01-01");
    EXPECT_EQ(formatText(days.back()), "2026-12-31");
    EXPECT_EQ(std::set<CivilDate>(days.begin(), days.end()).size(), 365U);
}

TEST(BenchSite, TheSampleIsMadeOfWholeSquaresAndOfReceiversOnly) {
    const BenchSite site = tests::tinySite();
    const Receivers all = pickMiddleReceivers(site, {}).value();
    const Receivers sample = sampleOf(all, 200, 1);
    EXPECT_GE(sample.cells.size(), 200U);
    EXPECT_LT(sample.cells.size(), 200U + 64U);
    EXPECT_TRUE(std::ranges::includes(all.cells, sample.cells));
    const auto ground = std::ranges::count(sample.kind, CellKind::ground);
    EXPECT_EQ(std::size_t(ground), sample.cells.size());
    EXPECT_EQ(sampleOf(all, 1'000'000, 1).cells, all.cells);
}

TEST(BenchSite, AStretchIsADayOfItsOwn) {
    const BenchSite site = tests::tinySite();
    const SunSteps day = computeSunOver(site, site.date, 1).value();
    const SunSteps stretch = sliceSteps(day, 100, 60);
    ASSERT_EQ(stretch.steps.size(), 60U);
    EXPECT_EQ(stretch.steps[0].direction, day.steps[100].direction);
    ASSERT_EQ(stretch.days.size(), 1U);
    EXPECT_EQ(stretch.days[0].count, 60U);
}

}  // namespace
}  // namespace noonmark::bench
