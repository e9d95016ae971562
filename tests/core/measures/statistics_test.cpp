#include "core/measures/statistics.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/measures/has_runs.h"

namespace noonmark {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

ShadowField threeReceivers() {
    ShadowField field;
    field.grid = {0, 0, 2, 4, 1};
    field.grossMin = {0, 60, nan, 30};
    field.continuousMin = {0, 20, nan, 10};
    field.sunlitMinutesPerDay = 90;
    return field;
}

TEST(Statistics, OfAFieldByHand) {
    EXPECT_TRUE(hasRuns(threeReceivers()));
    const ShadowStatistics figures = computeStatistics(threeReceivers());
    EXPECT_EQ(figures.receivers, 3U);
    EXPECT_EQ(figures.shadowAreaM2, 4);
    EXPECT_EQ(figures.meanGrossMin, 30);
    EXPECT_TRUE(hasRuns(figures));
    EXPECT_EQ(figures.meanContinuousMin, 10);
    EXPECT_EQ(figures.maxContinuousMin, 20);
}

TEST(Statistics, WithoutRunsTheirFiguresAreNoNumbers) {
    ShadowField field = threeReceivers();
    field.continuousMin.assign(4, nan);
    EXPECT_FALSE(hasRuns(field));
    const ShadowStatistics figures = computeStatistics(field);
    EXPECT_FALSE(hasRuns(figures));
    EXPECT_TRUE(std::isnan(figures.maxContinuousMin)) << "0 would say that there is no shadow";
    EXPECT_EQ(figures.meanGrossMin, 30);
    EXPECT_EQ(figures.maxGrossMin, 60);
}

TEST(Statistics, OnePieceWithoutRunsLeavesThemUnknownInAll) {
    ShadowField field = threeReceivers();
    ShadowSums sums = computeSums(field);
    field.continuousMin.assign(4, nan);
    sums.add(computeSums(field));
    sums.add({});  // a piece without receivers
    const ShadowStatistics figures = computeStatistics(sums, 90, 4);
    EXPECT_EQ(figures.receivers, 6U);
    EXPECT_EQ(figures.maxGrossMin, 60);
    EXPECT_FALSE(hasRuns(figures));
}

}  // namespace
}  // namespace noonmark
