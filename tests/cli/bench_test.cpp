#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/bench/bench_pages.h"
#include "app/bench/chart_painter.h"
#include "app/cli/base/offscreen_qt.h"
#include "core/lab/bench/paper/paper_bench.h"
#include "core/lab/lab_engines.h"
#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/core/lab/bench/tiny_site.h"

namespace noonmark::cli::tests {
namespace {

using noonmark::tests::readBytes;

TEST(BenchFiles, HoldTablesChartsAndTheSummary) {
    NoProgress silent;
    const auto report = bench::runPaperBench(bench::tests::tinySite(), bench::tests::minExtent(),
                                             coreAndLabEngines(), silent, {});
    ASSERT_TRUE(report) << report.error().text();
    const noonmark::tests::TemporaryFolder folder;
    const OffscreenQt qt;
    const auto files = writeBenchFiles(*report, folder.path("out"));
    ASSERT_TRUE(files) << files.error().text();
    std::vector<std::string> names;
    for (const auto& file : *files) names.push_back(file.filename().string());
    EXPECT_THAT(names, testing::UnorderedElementsAreArray(benchFileNames(bench::paperBenchKeys)));
    EXPECT_FALSE(writeBenchFiles(*report, folder.path("out"))) << "what is there is not replaced unasked";
    EXPECT_TRUE(writeBenchFiles(*report, folder.path("out"), {{}, true}));
    EXPECT_EQ(files->size(), report->findings.size() + 2);
    EXPECT_TRUE(readBytes(folder.path("out") / "report.pdf").starts_with("%PDF"));
    EXPECT_EQ(nlohmann::json::parse(readBytes(folder.path("out") / "summary.json")).size(), 9U);
    EXPECT_TRUE(readBytes(folder.path("out") / "time_by_days.csv")
                    .starts_with("engine,setting,days,time_s,runs,estimated\r\nray,,1,"));
}

TEST(BenchCommand, RefusesWhatItCannotUse) {
    const noonmark::tests::TemporaryFolder folder;
    const std::string out = folder.path("out").string();
    EXPECT_EQ(noonmarkCli({"bench"}).code, exitUsage);
    EXPECT_EQ(noonmarkCli({"bench", "paper"}).code, exitUsage);
    EXPECT_EQ(noonmarkCli({"bench", "paper", "--out", out, "--date", "tomorrow"}).code, exitUsage);
    EXPECT_EQ(noonmarkCli({"bench", "paper", "--out", out, "--zone", "Mars/Olympus"}).code, exitUsage);
    EXPECT_EQ(noonmarkCli({"bench", "paper", "--out", out, "--city", "/no/such.gpkg"}).code, exitUsage);
    EXPECT_EQ(noonmarkCli({"bench", "paper", "--out", "/proc/no/such"}).code, exitFailed);
    const std::string earlier = folder.path("earlier").string();
    std::filesystem::create_directory(earlier);
    std::ofstream(folder.path("earlier/level_error.csv")) << "level,error_pct\n";
    const CommandOutput refused = noonmarkCli({"bench", "paper", "--out", earlier});
    EXPECT_EQ(refused.code, exitUsage);
    EXPECT_THAT(refused.err, testing::HasSubstr("level_error.csv: There is a file of this name already"));
}

TEST(AxisScale, LinearAxesEndOnRoundNumbers) {
    const AxisScale axis({.label = "x", .fromZero = true}, {3, 47});
    EXPECT_EQ(axis.low(), 0);
    EXPECT_EQ(axis.high(), 50);
    EXPECT_EQ(axis.ticks().size(), 6U);
    EXPECT_EQ(axis.ticks().back().text, "50");
}

TEST(AxisScale, LogarithmicAxesHoldAllValuesAndMarkRoundOnes) {
    const AxisScale axis({.label = "s", .logarithmic = true}, {0.002, 0, 7000});
    EXPECT_FALSE(axis.shows(0));
    EXPECT_LT(axis.low(), axis.placeOf(0.002));
    EXPECT_GT(axis.high(), axis.placeOf(7000));
    ASSERT_GE(axis.ticks().size(), 3U);
    for (const AxisTick& tick : axis.ticks()) EXPECT_NEAR(tick.place, std::round(tick.place), 1e-9);
}

TEST(AxisScale, ASingleValueOrNoneStillMakesAnAxis) {
    EXPECT_GE(AxisScale({.label = "s", .logarithmic = true}, {300}).ticks().size(), 1U);
    EXPECT_GE(AxisScale({.label = "s"}, {}).ticks().size(), 2U);
}

}  // namespace
}  // namespace noonmark::cli::tests
