#include "core/measures/error_sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/engines/api/partial_field.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

City fewBoxes() { return cityOf({{{0, 0, 0}, {20, 20, 30}}, {{40, 10, 0}, {60, 30, 50}}}); }

TEST(ErrorSample, SpreadsEvenlyOverTheRegion) {
    const City city;
    const Receivers receivers = receiversOver(city, 0, 0, 400, 400);
    const auto cells = spreadReceivers(receivers, 320, 5);
    ASSERT_EQ(cells.size(), 320U);
    EXPECT_TRUE(std::ranges::is_sorted(cells));
    std::array<int, 16> inSquare{};
    for (const std::uint32_t cell : cells) ++inSquare[cell / 400 / 100 * 4 + cell % 400 / 100];
    EXPECT_GE(*std::ranges::min_element(inSquare), 17);
    EXPECT_LE(*std::ranges::max_element(inSquare), 23);
}

TEST(ErrorSample, TakesReceiversOnlyAndTheSameOnesForASeed) {
    const City city = fewBoxes();
    const Receivers receivers = receiversOver(city, -20, -20, 80, 80);
    const auto cells = spreadReceivers(receivers, 100, 1);
    EXPECT_EQ(cells.size(), 100U);
    for (const std::uint32_t cell : cells) EXPECT_EQ(receivers.kind[cell], CellKind::ground);
    EXPECT_EQ(spreadReceivers(receivers, 100, 1), cells);
    EXPECT_NE(spreadReceivers(receivers, 100, 2), cells);
}

TEST(ErrorSample, OfFewReceiversTakesAll) {
    const City city;
    const Receivers receivers = receiversOver(city, 0, 0, 5, 4);
    EXPECT_EQ(spreadReceivers(receivers, 300, 1), receivers.cells);
}

TEST(ErrorSample, LongPeriodsAreComparedOnFewerReceivers) {
    EXPECT_EQ(sampleSize({}, 360), 300U);
    EXPECT_EQ(sampleSize({}, 175'200), 300U);
    EXPECT_EQ(sampleSize({}, 1'000'000), 60U);
    EXPECT_EQ(sampleSize({}, 50'000'000), 30U);
    EXPECT_EQ(sampleSize({.receivers = 10}, 50'000'000), 10U);
    EXPECT_EQ(sampleSize({.receivers = 0}, 360), 0U);
}

TEST(ErrorSample, TheReferenceHasNoErrorAgainstItself) {
    const City city = fewBoxes();
    const Receivers receivers = receiversOver(city, -50, -50, 100, 100);
    const SunSteps sun = oneDay(arc(60, 50));
    NoProgress progress;
    const auto error = sampleError(city, receivers, sun, traced(city, receivers, sun), {}, progress, {});
    ASSERT_TRUE(error);
    EXPECT_EQ(error->receivers, 300U);
    EXPECT_EQ(error->gross.maxMin, 0);
    EXPECT_EQ(error->continuous.maxMin, 0);
    EXPECT_EQ(error->continuous.wholeMin, 60);
}

TEST(ErrorSample, FindsAKnownError) {
    const City city = fewBoxes();
    const Receivers receivers = receiversOver(city, -50, -50, 100, 100);
    const SunSteps sun = oneDay(arc(60, 50));
    ShadowField field = traced(city, receivers, sun);
    for (float& minutes : field.grossMin) minutes += 3;
    for (float& minutes : field.continuousMin) minutes -= 6;
    NoProgress progress;
    const auto error = sampleError(city, receivers, sun, field, {}, progress, {});
    ASSERT_TRUE(error);
    EXPECT_NEAR(error->areaPct, 5, 1e-5);
    EXPECT_NEAR(error->areaStandardErrorPct, 0, 1e-5);
    EXPECT_NEAR(error->gross.percent(error->gross.maxMin), 5, 1e-5);
    EXPECT_NEAR(error->continuous.percent(error->continuous.meanMin), 10, 1e-5);
}

TEST(ErrorSample, StopsWhenAsked) {
    const City city = fewBoxes();
    const Receivers receivers = receiversOver(city, -50, -50, 100, 100);
    const SunSteps sun = oneDay(arc(60, 50));
    std::stop_source stop;
    stop.request_stop();
    NoProgress progress;
    const auto error =
        sampleError(city, receivers, sun, traced(city, receivers, sun), {}, progress, stop.get_token());
    ASSERT_FALSE(error);
    EXPECT_TRUE(isCancelled(error.error()));
}

/// A viewer that accepts every partial result.
struct Onlooker final : Progress, PartialSink {
    void report(double, std::string_view) override {}
    [[nodiscard]] bool wants() const override { return true; }
    void take(PartialField) override { ++taken; }
    int taken = 0;
};

TEST(ErrorSample, IsNoRunningResult) {
    const City city = fewBoxes();
    const Receivers receivers = receiversOver(city, -50, -50, 100, 100);
    const SunSteps sun = oneDay(arc(60, 50));
    Onlooker onlooker;
    ASSERT_TRUE(sampleError(city, receivers, sun, traced(city, receivers, sun), {}, onlooker, {}));
    EXPECT_EQ(onlooker.taken, 0);
}

}  // namespace
}  // namespace noonmark
