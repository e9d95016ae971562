#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::cli::tests {
namespace {

using testing::HasSubstr;

// Two houses of 20 m and 30 m near Bryant Park; the height of one is in feet.
constexpr const char* twoHouses = R"({"type":"FeatureCollection","features":[
{"type":"Feature","id":1,"properties":{"name":"A","height":"20"},"geometry":{"type":"Polygon","coordinates":
 [[[-73.9840,40.7530],[-73.9837,40.7530],[-73.9837,40.7532],[-73.9840,40.7532],[-73.9840,40.7530]]]}},
{"type":"Feature","id":2,"properties":{"name":"B","height":"98.425 ft"},"geometry":{"type":"Polygon","coordinates":
 [[[-73.9834,40.7530],[-73.9831,40.7530],[-73.9831,40.7532],[-73.9834,40.7532],[-73.9834,40.7530]]]}}]})";

std::string contentOf(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::ostringstream content;
    content << stream.rdbuf();
    return content.str();
}

class StudyCommand : public testing::Test {
protected:
    CommandOutput study(const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"study",      city.string(),
                                           "--start",    "2026-03-21",
                                           "--from",     "09:00",
                                           "--hours",    "6",
                                           "--step",     "10",
                                           "--zone",     "America/New_York",
                                           "--region",   "-73.9845,40.7527,-73.9826,40.7537",
                                           "--cell",     "2",
                                           "--out",      out.string(),
                                           "--overwrite"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    }

    noonmark::tests::TemporaryFolder folder;
    std::filesystem::path city = folder.file("houses.geojson", twoHouses);
    std::filesystem::path out = folder.path("made/out");
};

TEST_F(StudyCommand, LeavesEverythingInTheFolder) {
    const CommandOutput output = study({"--cells-csv"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_EQ(output.err, "");
    for (const char* name : {"shadow.tif", "shadow.png", "report.pdf", "study.json", "cells.csv"}) {
        EXPECT_GT(std::filesystem::file_size(out / name), 100U) << name;
        EXPECT_THAT(output.out, HasSubstr((out / name).string()));
    }
    EXPECT_THAT(output.out, HasSubstr("m2"));
}

TEST_F(StudyCommand, MonthsAndContributionsComeFromTheHorizonSweep) {
    const CommandOutput output =
        study({"--days", "40", "--engine", "horizon", "--by", "month", "--contributions"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    for (const char* name : {"by_month.tif", "contributions.gpkg", "contributions.pdf"})
        EXPECT_GT(std::filesystem::file_size(out / name), 1000U) << name;
    EXPECT_THAT(contentOf(out / "by_month.csv"), HasSubstr("\n2026-04,"));
    EXPECT_THAT(contentOf(out / "contributions.csv"), HasSubstr(",A,"));
    EXPECT_THAT(contentOf(out / "contributions.csv"), HasSubstr("sole 2026-03"));
    EXPECT_THAT(contentOf(out / "study.json"), HasSubstr("--by month"));
    const CommandOutput refused = study({"--engine", "ray", "--contributions"});
    EXPECT_NE(refused.code, exitOk);
    EXPECT_THAT(refused.err, HasSubstr("Choose one of: horizon, auto"));
}

// The value of the style's last colour.
double endOfStyle(const std::string& qml) {
    const std::size_t last = qml.rfind("<item value=\"");
    return last == qml.npos ? 0 : std::stod(qml.substr(last + std::string("<item value=\"").size()));
}

// Eleven days of March and 29 of April, 6 h each. A day's range and classes say nothing about a month.
TEST_F(StudyCommand, TheStyleOfMonthsEndsAtTheSunOfTheLongestMonth) {
    const CommandOutput output =
        study({"--days", "40", "--by", "month", "--range", "0:200", "--classes", "50,100"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    constexpr double longest = 29 * 6 * 60;
    EXPECT_THAT(contentOf(out / "by_month.csv"), HasSubstr("\n2026-04,10440.0,"));
    const double end = endOfStyle(contentOf(out / "by_month.qml"));
    EXPECT_GE(end, longest);
    EXPECT_LT(end, 1.5 * longest);
    EXPECT_EQ(endOfStyle(contentOf(out / "shadow.qml")), std::numeric_limits<double>::infinity());
}

TEST_F(StudyCommand, StandardOutputIsTheJsonFileAndNothingElse) {
    const CommandOutput output = study({"--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_EQ(output.json(), nlohmann::json::parse(contentOf(out / "study.json")));
    EXPECT_FALSE(std::filesystem::exists(out / "cells.csv"));
}

TEST_F(StudyCommand, FiguresAndKeys) {
    const auto json = study({"--json"}).json();
    EXPECT_EQ(json["engine"], "auto");
    EXPECT_EQ(json["engine_used"], "projected");
    EXPECT_EQ(json["steps"], 36);
    EXPECT_EQ(json["buildings_used"], 2);
    EXPECT_GT(json["receivers"], 3000);
    EXPECT_GT(json["shadow_area_m2"], 0);
    EXPECT_GT(json["mean_gross_min"], 0);
    EXPECT_LE(json["mean_continuous_min"], json["mean_gross_min"]);
    EXPECT_LE(json["max_continuous_min"], 360);
    EXPECT_GE(json["seconds"]["total"], json["seconds"]["accumulate"]);
    EXPECT_TRUE(json["seconds"].contains("read"));
    EXPECT_TRUE(json["warnings"].is_array());
    ASSERT_EQ(json["inputs"].size(), 1U);
    EXPECT_EQ(json["inputs"][0]["sha256"].get<std::string>().size(), 64U);
}

TEST_F(StudyCommand, TheErrorIsMeasuredUnlessItIsSwitchedOff) {
    const CommandOutput output = study({"--engine", "iam"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_THAT(output.out, HasSubstr("cell error, gross"));
    const auto json = study({"--engine", "iam", "--json", "--error-sample", "40"}).json();
    EXPECT_EQ(json["error"]["sample_receivers"], 40);
    EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--error-sample 40"));
    const auto without = study({"--engine", "iam", "--json", "--no-error-sample"}).json();
    EXPECT_TRUE(without["error"]["gross"].is_null());
    EXPECT_THAT(without["repeat"].get<std::string>(), HasSubstr("--error-sample 0"));
    EXPECT_FALSE(without["seconds"].contains("error_sample"));
}

TEST_F(StudyCommand, GrossShadowAloneIsReportedAsSuchInEveryFile) {
    for (const char* engine : {"horizon", "auto"}) {
        // auto chooses projected shadows, which compute continuous shadow in any case.
        const CommandOutput both = study({"--days", "30", "--engine", engine, "--json"});
        const CommandOutput output =
            study({"--days", "30", "--engine", engine, "--option", "runs=0", "--cells-csv"});
        ASSERT_EQ(output.code, exitOk) << output.err;
        const auto json = nlohmann::json::parse(contentOf(out / "study.json"));
        EXPECT_EQ(json["engine_options"]["runs"], 0);
        EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--option runs=0"));
        EXPECT_EQ(json["mean_gross_min"], both.json()["mean_gross_min"]);
        const bool swept = json["engine_used"] == "horizon";
        EXPECT_EQ(json["mean_continuous_min"].is_null(), swept) << engine;
        EXPECT_EQ(json["max_continuous_min"].is_null(), swept);
        EXPECT_EQ(json["error"]["continuous"].is_null(), swept);
        EXPECT_TRUE(json["error"]["gross"]["mean_pct"].is_number());
        EXPECT_EQ(output.out.find("not counted") != std::string::npos, swept) << output.out;
        EXPECT_EQ(output.out.find("nan"), std::string::npos) << output.out;
        const std::string cells = contentOf(out / "cells.csv");
        EXPECT_EQ(cells.find(",continuous_min") == std::string::npos, swept);
        EXPECT_EQ(cells.find("nan"), std::string::npos);
    }
}

TEST_F(StudyCommand, RunsAreCountedOrNot) {
    EXPECT_NE(study({"--engine", "horizon", "--option", "runs=2"}).code, exitOk);
    EXPECT_NE(study({"--engine", "horizon", "--option", "runs=0.5"}).code, exitOk);
    EXPECT_EQ(study({"--engine", "horizon", "--option", "runs=1"}).code, exitOk);
}

TEST_F(StudyCommand, RefractionCanBeLeftOut) {
    EXPECT_EQ(study({"--json"}).json()["period"]["refraction"], true);
    EXPECT_EQ(study({"--json", "--no-refraction"}).json()["period"]["refraction"], false);
}

TEST_F(StudyCommand, SolarWindowNeedsNoZone) {
    const CommandOutput output =
        noonmarkCli({"study", city.string(), "--start", "2026-03-21", "--window", "sunrise+1.5h..sunset-1.5h",
                     "--step", "30", "--region", "-73.9845,40.7527,-73.9826,40.7537", "--cell", "5", "--out",
                     out.string(), "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_EQ(output.json()["period"]["window"]["after_sunrise_min"], 90);
    EXPECT_NEAR(output.json()["period"]["window"]["sunrise_altitude_deg"].get<double>(), -0.833, 0.001);
    // The whole window: 12 h 10 min of daylight minus 3 h, that is 18 steps of about 30 min.
    const double minutes = output.json()["period"]["hours_min_per_day"];
    EXPECT_NEAR(minutes, 550, 3);
    EXPECT_EQ(output.json()["steps"], 18);
    EXPECT_NEAR(output.json()["sunlit_min_per_day"].get<double>(), minutes, 1e-6);
    EXPECT_NEAR(output.json()["period"]["counted_step_min"].get<double>(), minutes / 18, 1e-9);
}

TEST_F(StudyCommand, WhatTheSettingsHoldCanBeStatedAndIsRepeated) {
    const CommandOutput output =
        noonmarkCli({"study", city.string(), "--start", "2026-03-21", "--window", "sunrise..sunset",
                     "--centre", "--far-away", "20000", "--step", "30", "--region",
                     "-73.9845,40.7527,-73.9826,40.7537", "--cell", "5", "--out", out.string(), "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_EQ(output.json()["period"]["window"]["sunrise_altitude_deg"], 0);
    EXPECT_THAT(output.json()["repeat"].get<std::string>(), HasSubstr("--centre"));
    EXPECT_THAT(output.json()["repeat"].get<std::string>(), HasSubstr("--far-away 20000"));
}

TEST_F(StudyCommand, AFolderThatCannotBeMadeIsAFailure) {
    out = folder.file("in the way", "a file") / "out";
    const CommandOutput output = study({});
    EXPECT_EQ(output.code, exitFailed);
    EXPECT_THAT(output.err, HasSubstr("in the way"));
}

TEST_F(StudyCommand, TheFolderIsTriedBeforeTheWork) {
    out = folder.file("in the way", "a file");
    // The study would fail as well, because it is night: the error must be about the folder.
    const CommandOutput output = noonmarkCli({"study", city.string(), "--start", "2026-03-21", "--from",
                                              "22:00", "--zone", "America/New_York", "--region",
                                              "-73.9845,40.7527,-73.9826,40.7537", "--out", out.string()});
    EXPECT_EQ(output.code, exitFailed);
    EXPECT_THAT(output.err, HasSubstr("in the way"));
}

TEST_F(StudyCommand, InfoAgreesWithWhatIsThere) {
    const CommandOutput output = noonmarkCli({"info", city.string(), "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    EXPECT_EQ(json["buildings"], 2);
    EXPECT_EQ(json["parts"], 2);
    EXPECT_EQ(json["triangles"], 24);
    EXPECT_EQ(json["height_sources"]["measured"], 2);
    EXPECT_NEAR(json["tallest_m"].get<double>(), 30, 0.001);
    EXPECT_TRUE(json["warnings"].is_array());
    EXPECT_THAT(noonmarkCli({"info", city.string()}).out, HasSubstr("30.0 m"));
}

TEST_F(StudyCommand, ImportedCityGivesTheSameAnswer) {
    const auto before = study({"--json"}).json();
    const auto copy = folder.path("copy.gpkg");
    ASSERT_EQ(noonmarkCli({"import", city.string(), "--out", copy.string(), "--json"}).json()["buildings"],
              2);
    city = copy;
    const auto after = study({"--json"}).json();
    EXPECT_NEAR(after["shadow_area_m2"].get<double>(), before["shadow_area_m2"].get<double>(), 1);
}

TEST(SampleCommand, WritesWhatInfoReads) {
    const noonmark::tests::TemporaryFolder folder;
    const std::string file = folder.path("grid.gpkg").string();
    const CommandOutput written =
        noonmarkCli({"sample", "grid", "--buildings", "200", "--seed", "3", "--out", file, "--json"});
    ASSERT_EQ(written.code, exitOk) << written.err;
    const auto info = noonmarkCli({"info", file, "--json"}).json();
    EXPECT_EQ(info["buildings"], written.json()["buildings"]);
    EXPECT_EQ(info["parts"], written.json()["parts"]);
    EXPECT_EQ(noonmarkCli({"info", "sample:central-park-south", "--json"}).code, exitOk);
}

}  // namespace
}  // namespace noonmark::cli::tests
