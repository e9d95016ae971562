#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/measures/shadow_figures.h"
#include "core/measures/statistics.h"

namespace noonmark {

namespace {

Bars::Class classOf(const Bars& bars, std::size_t group) {
    return std::get<Bars::Class>(bars.groups[group].name);
}

TEST(Histogram, AreasAreDividedByHoursOfSun) {
    // 12 h are possible: classes of an hour. Sun of 0, 1 h (the limit belongs to the class above), 11.5 and
    // 12 h (the last class is closed), and a cell that is no receiver.
    ShadowField field{.grid = {.columns = 5, .rows = 1}, .sunlitMinutesPerDay = 720, .days = 2};
    field.grossMin = {720, 660, 30, 0, NAN};
    const Bars bars = makeSunHistogram(field);
    ASSERT_EQ(bars.groups.size(), 12);
    EXPECT_EQ(classOf(bars, 0), (Bars::Class{0, 1}));
    EXPECT_EQ(classOf(bars, 11), (Bars::Class{11, 12}));
    EXPECT_DOUBLE_EQ(bars.groups[0].values.front(), 25);
    EXPECT_DOUBLE_EQ(bars.groups[1].values.front(), 25);
    EXPECT_DOUBLE_EQ(bars.groups[11].values.front(), 50);
}

TEST(Histogram, AFewHoursAreDividedFinely) {
    const Bars bars = makeSunHistogram(std::vector<double>{10, 50}, 60, "Share");
    ASSERT_EQ(bars.groups.size(), 4);
    EXPECT_EQ(classOf(bars, 0), (Bars::Class{0, 0.25}));
    EXPECT_DOUBLE_EQ(bars.groups[3].values.front(), 50);
}

TEST(Histogram, WithoutReceiversOrSunThereAreNoBars) {
    EXPECT_TRUE(makeSunHistogram(std::vector<double>{NAN}, 60, "Share").groups.empty());
    EXPECT_TRUE(makeSunHistogram(std::vector<double>{0}, 0, "Share").groups.empty());
    EXPECT_TRUE(makeChangeHistogram(std::vector<float>{0, NAN, 0.0005F}, 1, 1e-3).groups.empty());
}

TEST(Histogram, ChangesAreDividedAroundZeroAndTellGainFromLoss) {
    const Bars bars = makeChangeHistogram(std::vector<float>{-3, 0, 12, 14, NAN, 29}, 4, 1e-3);
    ASSERT_EQ(bars.groups.size(), 7) << "-5 to 30 by 5";
    EXPECT_EQ(classOf(bars, 0), (Bars::Class{-5, 0}));
    EXPECT_EQ(bars.groups[0].tone, BarTone::gain);
    EXPECT_EQ(bars.groups[1].tone, BarTone::loss);
    EXPECT_DOUBLE_EQ(bars.groups[0].values.front(), 4);
    EXPECT_DOUBLE_EQ(bars.groups[3].values.front(), 8);
    double all = 0;
    for (const auto& group : bars.groups) all += group.values.front();
    EXPECT_DOUBLE_EQ(all, 16) << "the cell without a change is left out";
}

TEST(Histogram, AsSunTheSameAreasAreGainedAndLostWithTheOppositeSign) {
    const std::vector<float> minutes{-3, 0, 12, 14, NAN, 29};
    const Bars bars = makeChangeHistogram(minutes, 4, 1e-3, ShownAs::sun);
    ASSERT_EQ(bars.groups.size(), 7) << "-30 to 5 by 5";
    EXPECT_EQ(classOf(bars, 0), (Bars::Class{-30, -25}));
    EXPECT_EQ(bars.groups[0].tone, BarTone::loss);
    EXPECT_EQ(bars.groups[6].tone, BarTone::gain);
    EXPECT_DOUBLE_EQ(bars.groups[0].values.front(), 4);
    EXPECT_DOUBLE_EQ(bars.groups[6].values.front(), 4);
}

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
