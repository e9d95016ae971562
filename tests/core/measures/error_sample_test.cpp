#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/measures/error_sample.h"
#include "core/measures/shadow_figures.h"
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

// A hundred cells: in cell i gross shadow is i minutes too high, in cell 7 continuous shadow is an hour too
// low.
std::vector<ComparedCell> hundredCells() {
    std::vector<ComparedCell> cells;
    for (int i = 1; i <= 100; ++i)
        cells.push_back({{double(i), 0.5}, 100.0 + i, 100, i == 7 ? 0.0 : 60.0, 60});
    return cells;
}

TEST(SampledError, KnownFigures) {
    const SampledError error = errorOf(hundredCells(), 1000, 600);
    EXPECT_EQ(error.receivers, 100U);
    EXPECT_DOUBLE_EQ(error.gross.meanMin, 50.5);
    EXPECT_DOUBLE_EQ(error.gross.p99Min, 99);
    EXPECT_DOUBLE_EQ(error.gross.maxMin, 100);
    EXPECT_EQ(error.gross.worstM, glm::dvec2(100, 0.5));
    EXPECT_DOUBLE_EQ(error.gross.percent(error.gross.maxMin), 10);
    EXPECT_NEAR(error.areaPct, 5.05, 1e-12);
    // Standard deviation of 1 .. 100 minutes: sqrt(101 * 100 / 12) = 29.01; over sqrt(100), of 1000.
    EXPECT_NEAR(error.areaStandardErrorPct, 0.290115, 1e-6);
    EXPECT_DOUBLE_EQ(error.continuous.meanMin, 0.6);
    EXPECT_DOUBLE_EQ(error.continuous.p99Min, 0);
    EXPECT_DOUBLE_EQ(error.continuous.percent(error.continuous.maxMin), 10);
    EXPECT_EQ(error.continuous.worstM, glm::dvec2(7, 0.5));
}

TEST(SampledError, WithoutRunsNothingIsReportedOfThem) {
    std::vector<ComparedCell> cells = hundredCells();
    cells[50].continuousMin = std::nan("");
    const SampledError error = errorOf(cells, 1000, 600);
    EXPECT_FALSE(hasRuns(error));
    EXPECT_DOUBLE_EQ(error.gross.meanMin, 50.5);
}

TEST(SampledError, DifferencesThatCancelAreNoAreaErrorButCellError) {
    const std::vector<ComparedCell> cells{{{0, 0}, 110, 100, 5, 5}, {{1, 0}, 90, 100, 5, 5}};
    const SampledError error = errorOf(cells, 200, 200);
    EXPECT_DOUBLE_EQ(error.areaPct, 0);
    EXPECT_DOUBLE_EQ(error.gross.percent(error.gross.meanMin), 5);
}

TEST(SampledError, TooLittleShadowIsANegativeArea) {
    EXPECT_DOUBLE_EQ(errorOf(std::vector<ComparedCell>{{{0, 0}, 90, 100, 5, 5}}, 200, 200).areaPct, -5);
}

TEST(SampledError, OfNothingIsZero) {
    const SampledError error = errorOf({}, 0, 0);
    EXPECT_EQ(error.receivers, 0U);
    EXPECT_EQ(error.gross.percent(error.gross.maxMin), 0);
    EXPECT_FALSE(std::isnan(error.areaPct));
}

}  // namespace

}  // namespace noonmark
