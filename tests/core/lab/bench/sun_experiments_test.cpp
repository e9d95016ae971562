#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "core/lab/bench/paper/paper_bench.h"
#include "core/lab/graph/direction_graph.h"
#include "tests/core/lab/bench/tiny_site.h"

namespace noonmark::bench {
namespace {

double numberIn(const Finding& finding, std::size_t row, std::size_t column) {
    return std::get<double>(finding.table.rows.at(row).at(column));
}

// Table 1 has five digits of the mean cosine; its deviations from an hour on are those of the sun's path.
TEST(SunLinearity, AgreesWithThePapersTable) {
    NoProgress silent;
    const Finding finding = benchSunLinearity(tests::tinySite(), {}, {silent, {}}).value();
    ASSERT_EQ(finding.table.rows.size(), 6U);
    for (std::size_t row = 0; row < 6; ++row) {
        EXPECT_NEAR(numberIn(finding, row, 1), numberIn(finding, row, 6), 1e-4);
    }
    for (std::size_t row = 1; row < 6; ++row)  // longer intervals have larger differences
        EXPECT_GT(numberIn(finding, row, 4), numberIn(finding, row - 1, 4));
    EXPECT_NEAR(numberIn(finding, 4, 2), 25.5e-6, 5e-6);
    EXPECT_NEAR(numberIn(finding, 5, 2), 415e-6, 60e-6);
}

// The graph's edges are the distinct pairs of bins of the year's hours.
TEST(GraphBound, EdgesAreThoseCountedOneByOne) {
    const BenchSite site = tests::tinySite();
    const SunSteps year = computeYearSun(site).value();
    const DirectionBins bins(year, 5, 60);
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const SunDay& day : year.days)
        for (std::uint32_t hour = 0; hour < 6; ++hour) {
            const SunStep &first = year.steps[day.first + hour * 60],
                          &last = year.steps[day.first + hour * 60 + 59];
            pairs.emplace(bins.of(glm::dvec3(first.direction)), bins.of(glm::dvec3(last.direction), 1));
        }
    NoProgress silent;
    const Finding finding = benchGraphBound(site, {}, {silent, {}}).value();
    EXPECT_EQ(finding.summary.at("graph_edges"), double(pairs.size()));
    EXPECT_EQ(finding.summary.at("graph_intervals"), 365.0 * 6);
}

// A direction is at most half a bin's width from the bin's mean: cos(5 deg / sqrt 2) = 0.9981.
TEST(GraphBound, DirectionsAreAlikeWithinTheBound) {
    NoProgress silent;
    const Finding finding = benchGraphBound(tests::tinySite(), {}, {silent, {}}).value();
    EXPECT_GT(numberIn(finding, 2, 3), 0.999);
    EXPECT_LT(numberIn(finding, 2, 3), 1);
    EXPECT_GT(numberIn(finding, 2, 6), numberIn(finding, 2, 3));  // an edge is closer than a bin
    EXPECT_GT(numberIn(finding, 0, 3), numberIn(finding, 4, 3));  // small bins are closer than large ones
}

TEST(GraphError, AreaErrorIsNeverMoreThanWhatIsMistagged) {
    NoProgress silent;
    Extent extent = tests::minExtent();
    extent.graphHours = 6;
    const Finding finding = benchGraphError(tests::tinySite(), extent, {silent, {}}).value();
    ASSERT_GE(finding.table.rows.size(), 5U);
    for (std::size_t row = 0; row < finding.table.rows.size(); ++row) {
        EXPECT_LE(numberIn(finding, row, 5), numberIn(finding, row, 6) + 1e-9);
        EXPECT_GT(numberIn(finding, row, 3), 0);
        EXPECT_LE(numberIn(finding, row, 3), 100);
    }
    EXPECT_LT(finding.summary.at("graph_mistagged_pct"), 10);
}

}  // namespace
}  // namespace noonmark::bench
