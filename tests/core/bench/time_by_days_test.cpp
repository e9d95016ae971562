#include "core/bench/paper/engine_scaling.h"

#include <gtest/gtest.h>

namespace noonmark::bench {
namespace {

PeriodRun runOf(int days, double raySeconds, Placing iam) {
    return {
        .days = days,
        .contestants = {{"ray", "Ray reference", "", nullptr}, {"iam", "Inverse accrual map", "", nullptr}},
        .placings = {{.medianS = raySeconds, .runs = 1, .estimated = days > 1}, std::move(iam)}};
}

TEST(TimeByDays, TheYearsSpeedupIsRaysOverTheGraph) {
    const Finding finding = benchTimeByDays(
        {runOf(1, 1, {.medianS = 1, .runs = 5}), runOf(365, 365, {.medianS = 5, .runs = 5})}, {});
    EXPECT_DOUBLE_EQ(finding.summary.at("year_graph_speedup"), 73);
    EXPECT_EQ(std::get<std::string>(finding.table.rows[0].back()), "no");
    EXPECT_EQ(std::get<std::string>(finding.table.rows[1].back()), "yes");
}

TEST(TimeByDays, WhoWasTooSlowIsWorkedOutInProportionAndMarked) {
    const Finding finding = benchTimeByDays(
        {runOf(1, 1, {.medianS = 2, .runs = 5}), runOf(365, 365, {.refusal = "stopped", .tooSlow = true})},
        {});
    const auto& row = finding.table.rows.back();
    EXPECT_EQ(std::get<double>(row[3]), 730);
    EXPECT_EQ(std::get<std::string>(row.back()), "yes");
    EXPECT_FALSE(finding.summary.contains("year_graph_speedup"));
}

TEST(TimeByDays, WhoRefusedHasNoTime) {
    const Finding finding =
        benchTimeByDays({runOf(1, 1, {.refusal = "terrain"}), runOf(365, 365, {.refusal = "terrain"})}, {});
    EXPECT_EQ(finding.table.rows.size(), 2U);  // those of the rays
    EXPECT_FALSE(finding.summary.contains("year_graph_speedup"));
}

}  // namespace
}  // namespace noonmark::bench
