#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/lab/bench/contests/contest.h"
#include "core/lab/bench/paper/paper_bench.h"
#include "core/lab/lab_engines.h"
#include "tests/core/lab/bench/tiny_site.h"

namespace noonmark::bench {

namespace {

class PaperBenchTest : public testing::Test {
protected:
    static const BenchReport& report() {
        static const BenchReport made = [] {
            NoProgress silent;
            return runPaperBench(tests::tinySite(), tests::minExtent(), coreAndLabEngines(), silent, {})
                .value();
        }();
        return made;
    }
    static const Finding& finding(const std::string& key) {
        for (const Finding& one : report().findings)
            if (one.key == key) return one;
        throw std::out_of_range(key);
    }
};

TEST_F(PaperBenchTest, EveryExperimentIsMade) {
    ASSERT_EQ(report().findings.size(), paperBenchKeys.size());
    for (std::size_t i = 0; i < report().findings.size(); ++i) {
        const Finding& one = report().findings[i];
        EXPECT_EQ(one.key, paperBenchKeys[i]) << one.title << ": " << one.text;
    }
}

TEST_F(PaperBenchTest, EveryRowHasEveryColumn) {
    for (const Finding& one : report().findings) {
        EXPECT_FALSE(one.table.rows.empty()) << one.key;
        for (const auto& row : one.table.rows) EXPECT_EQ(row.size(), one.table.columns.size()) << one.key;
        for (const auto& comparison : one.comparisons)
            for (const auto& row : comparison.rows)
                EXPECT_EQ(row.size(), comparison.header.size()) << one.key;
    }
}

TEST_F(PaperBenchTest, TheSummaryHasTheKeysThatOthersRead) {
    const auto json = nlohmann::ordered_json::parse(summaryJson(report()));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"sam_vs_shadow_map", "iam_vs_ray", "iam_area_error_mean_pct",
                                              "iam_area_error_max_pct", "graph_edges", "graph_intervals",
                                              "graph_area_error_mean_pct", "graph_mistagged_pct",
                                              "year_graph_speedup"}));
    EXPECT_GT(json["iam_vs_ray"].get<double>(), 0);
    EXPECT_EQ(json["graph_intervals"], 2190);
    EXPECT_TRUE(json["sam_vs_shadow_map"].is_null());   // core has no OpenGL
    EXPECT_TRUE(json["year_graph_speedup"].is_null());  // three days are not a year
}

TEST_F(PaperBenchTest, TheRayReferenceHasNoErrorAnywhere) {
    for (const auto& row : finding("engine_times").table.rows)
        if (std::get<std::string>(row[0]) == "ray") {
            EXPECT_EQ(std::get<double>(row[5]), 0);
        }
}

TEST_F(PaperBenchTest, AnHourAndADayHaveEverySetting) {
    std::set<std::string> settings;
    for (const auto& row : finding("time_against_error").table.rows)
        if (std::get<std::string>(row[0]) == "a day") settings.insert(std::get<std::string>(row[2]));
    EXPECT_TRUE(settings.contains("levels 6"));
    EXPECT_TRUE(settings.contains("error 0.1 %"));
    EXPECT_TRUE(settings.contains("no graph"));
}

TEST_F(PaperBenchTest, ErrorFallsWithTheLevels) {
    const auto& series = finding("level_error").charts[0].series[0];
    ASSERT_EQ(series.points.size(), 6U);
    EXPECT_GE(series.points[0].y, series.points[2].y);
}

constexpr const char* noTime = "left out: there was no time for it";

// Number of rows marked as left out.
std::size_t leftOut(const std::string& key, const BenchReport& report) {
    std::size_t count = 0;
    for (const Finding& finding : report.findings)
        for (const auto& row : finding.table.rows)
            if (const auto* words = std::get_if<std::string>(&row.back()); finding.key == key && words)
                count += *words == noTime ? 1 : 0;
    return count;
}

// As on a machine that is too slow for any optional experiment.
TEST(PaperBench, WithoutTimeTheSummaryIsMadeAllTheSame) {
    NoProgress silent;
    Extent extent = tests::minExtent();
    extent.budgetS = 0;
    extent.resolutions = {16, 24, 32};
    const BenchReport report =
        runPaperBench(tests::tinySite(), extent, coreAndLabEngines(), silent, {}).value();
    EXPECT_EQ(report.findings.size(), 9U);
    const auto json = nlohmann::ordered_json::parse(summaryJson(report));
    for (const char* key : {"iam_vs_ray", "iam_area_error_mean_pct", "graph_edges", "graph_mistagged_pct"})
        EXPECT_FALSE(json[key].is_null()) << key;
    std::map<std::string, std::size_t> rows;
    for (const Finding& finding : report.findings) rows[finding.key] = finding.table.rows.size();
    const std::size_t engines = listDefaultEngines(coreAndLabEngines()).contestants.size();
    EXPECT_EQ(rows["time_by_resolution"], 3 * engines);
    EXPECT_EQ(rows["memory_by_resolution"], 2 * engines) << "two resolutions are measured in any case";
    EXPECT_EQ(leftOut("engine_times", report), engines) << "the second of two days";
    EXPECT_EQ(leftOut("time_by_resolution", report), engines);
    for (const auto& row : report.findings.front().table.rows)
        if (const auto& setting = std::get<std::string>(row[2]); !setting.empty() && setting != "no graph") {
            EXPECT_EQ(std::get<std::string>(row.back()), noTime) << setting;
        }
}

TEST(PaperBench, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    NoProgress silent;
    const auto report =
        runPaperBench(tests::tinySite(), tests::minExtent(), coreAndLabEngines(), silent, stop.get_token());
    ASSERT_FALSE(report);
    EXPECT_TRUE(isCancelled(report.error()));
}

TEST(PaperBench, ACityWithoutBuildingsIsRefused) {
    NoProgress silent;
    const auto report = runPaperBench({}, tests::minExtent(), coreAndLabEngines(), silent, {});
    ASSERT_FALSE(report);
    EXPECT_NE(report.error().what.find("no buildings"), std::string::npos);
}

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
