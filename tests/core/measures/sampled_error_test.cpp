#include "core/measures/error_sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/measures/has_runs.h"

namespace noonmark {
namespace {

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

TEST(SampledError, WithoutRunsNothingIsSaidOfThem) {
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
