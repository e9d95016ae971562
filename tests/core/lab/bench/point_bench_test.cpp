#include "core/lab/bench/points/point_bench.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/lab/lab_engines.h"
#include "tests/core/lab/bench/tiny_site.h"

namespace noonmark::bench {
namespace {

TEST(PointBench, MeasuresEveryFigureOfItsSummary) {
    NoProgress silent;
    const auto report = runPointBench(tests::tinySite(), tests::minExtent(), coreAndLabEngines(), silent, {});
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(report->findings.size(), pointBenchKeys.size());
    EXPECT_EQ(report->findings[0].key, pointBenchKeys[0]) << report->findings[0].text;
    for (const auto& row : report->findings[0].table.rows)
        EXPECT_EQ(row.size(), report->findings[0].table.columns.size());
    const auto json = nlohmann::json::parse(summaryJson(*report));
    for (const auto& [key, value] : json.items()) EXPECT_TRUE(value.is_number()) << key;
    EXPECT_LT(json["points_error_mean_pct"].get<double>(), 0.3);
}

}  // namespace
}  // namespace noonmark::bench
