#include "core/lab/bench/horizon/horizon_bench.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/lab/lab_engines.h"
#include "tests/core/lab/bench/tiny_site.h"

namespace noonmark::bench {
namespace {

class HorizonBenchTest : public testing::Test {
protected:
    static const BenchReport& report() {
        static const BenchReport made = [] {
            NoProgress silent;
            Extent extent = tests::minExtent();
            extent.binsDeg = {0.5, 2};
            return runHorizonBench(tests::tinySite(), extent, coreAndLabEngines(), silent, {}).value();
        }();
        return made;
    }
};

TEST_F(HorizonBenchTest, TheSummaryHasTheKeysThatOthersReadAllMeasured) {
    const auto json = nlohmann::ordered_json::parse(summaryJson(report()));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) {
        keys.push_back(key);
        EXPECT_TRUE(value.is_number()) << key;
    }
    EXPECT_EQ(keys, (std::vector<std::string>{
                        "year_vs_ray", "year_with_runs_vs_ray", "year_cell_error_mean_pct",
                        "year_cell_error_max_pct", "day_vs_ray", "day_mistagged_pct", "retime_fraction",
                        "retime_with_runs_fraction", "edit_fraction", "edit_with_runs_fraction", "edit_ms",
                        "day_edit_fraction", "day_edit_ms"}));
    EXPECT_LT(json["year_cell_error_mean_pct"].get<double>(), 0.5);
    EXPECT_LT(json["day_mistagged_pct"].get<double>(), 0.05);
}

TEST_F(HorizonBenchTest, WiderBinsAreFartherOff) {
    const Finding& year = report().findings.front();
    ASSERT_EQ(year.key, "horizon_year") << year.text;
    ASSERT_EQ(year.table.rows.size(), 4U);  // the first two use the error target
    EXPECT_LT(std::get<double>(year.table.rows[2][2]), std::get<double>(year.table.rows[3][2]));
}

TEST_F(HorizonBenchTest, EveryExperimentIsMadeAndEveryRowHasEveryColumn) {
    ASSERT_EQ(report().findings.size(), horizonBenchKeys.size());
    for (std::size_t i = 0; i < report().findings.size(); ++i) {
        const Finding& one = report().findings[i];
        EXPECT_EQ(one.key, horizonBenchKeys[i]) << one.title << ": " << one.text;
        EXPECT_FALSE(one.table.rows.empty()) << one.key;
        for (const auto& row : one.table.rows) EXPECT_EQ(row.size(), one.table.columns.size()) << one.key;
    }
}

TEST(ListMissed, AllowsAQuarterAndNothingUnmeasured) {
    BenchReport report;
    for (const auto& [key, target, value] : {std::tuple("fast", atLeast(2000), 1601.0),
                                             {"slow", atLeast(2000), 1599.0},
                                             {"small", atMost(0.02), 0.0249},
                                             {"large", atMost(0.02), 0.0251}}) {
        report.summary.push_back(targetFigure(key, "what", target));
        report.summary.back().value = value;
    }
    report.summary.push_back(targetFigure("unmeasured", "what", atMost(1)));
    report.summary.push_back({"untargeted", "what", ""});
    std::vector<std::string> missed;
    for (const SummaryFigure& figure : listMissed(report)) missed.push_back(figure.key);
    EXPECT_EQ(missed, (std::vector<std::string>{"slow", "large", "unmeasured"}));
    EXPECT_EQ(report.summary[0].paper, ">= 2000");
    EXPECT_EQ(report.summary[3].paper, "<= 0.02");
}

}  // namespace
}  // namespace noonmark::bench
