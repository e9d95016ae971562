#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/command_output.h"

namespace noonmark::cli::tests {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

const std::vector<std::string> golden{"sun",
                                      "--lat",
                                      "39.742476",
                                      "--lon",
                                      "-105.1786",
                                      "--elevation",
                                      "1830.14",
                                      "--pressure",
                                      "820",
                                      "--temperature",
                                      "11",
                                      "--at",
                                      "2003-10-17T12:30:30-07:00"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::vector<std::string> withAir(const std::string& pressureHPa, const std::string& temperatureC) {
    auto arguments = with(golden, {"--json"});
    *(std::ranges::find(arguments, "--pressure") + 1) = pressureHPa;
    *(std::ranges::find(arguments, "--temperature") + 1) = temperatureC;
    return arguments;
}

// The example of the SPA report (NREL/TP-560-34302, table A5.1). Its day is that of UT: the sunset that it
// prints, 17:20:19, belongs to the evening before; the sunset after this transit is 87 s earlier. Its sunrise
// and sunset bend light as at 1010 hPa and 10 C, whatever the air: those are asked for here.
TEST(Sun, ExampleOfTheSpaReport) {
    const CommandOutput output = noonmarkCli(with(golden, {"--json"}));
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    EXPECT_NEAR(json["azimuth_deg"].get<double>(), 194.340241, 0.0003);
    EXPECT_NEAR(json["altitude_apparent_deg"].get<double>(), 90 - 50.111622, 0.0005);
    EXPECT_LT(json["altitude_true_deg"], json["altitude_apparent_deg"]);
    EXPECT_EQ(json["day_kind"], "ordinary");
    EXPECT_THAT(json["transit"].get<std::string>(), MatchesRegex("2003-10-17T11:46:0[345]-07:00"));

    const auto standard = noonmarkCli(withAir("1010", "10")).json();
    EXPECT_THAT(standard["sunrise"].get<std::string>(), MatchesRegex("2003-10-17T06:12:4[23]-07:00"));
    EXPECT_THAT(standard["sunset"].get<std::string>(), MatchesRegex("2003-10-17T17:18:5[123]-07:00"));
}

// Thin air bends less: 34' x (1 - 820/1010 x 283/284) = 0.109 deg. The sun climbs 15 deg/h x cos(latitude) x
// sin(azimuth at sunrise, 102 deg) = 0.188 deg/min: sunrise is 35 s later and sunset as much earlier.
TEST(Sun, RisesLaterInThinAir) {
    const auto thin = noonmarkCli(with(golden, {"--json"})).json();
    EXPECT_THAT(thin["sunrise"].get<std::string>(), MatchesRegex("2003-10-17T06:13:1[789]-07:00"));
    EXPECT_THAT(thin["sunset"].get<std::string>(), MatchesRegex("2003-10-17T17:18:1[678]-07:00"));
}

TEST(Sun, AZoneChangesHowTimesAreWrittenOnly) {
    const auto there = noonmarkCli(with(golden, {"--json", "--zone", "Europe/Berlin"})).json();
    const auto here = noonmarkCli(with(golden, {"--json"})).json();
    EXPECT_EQ(there["azimuth_deg"], here["azimuth_deg"]);
    EXPECT_EQ(there["at"], "2003-10-17T21:30:30+02:00");
}

TEST(Sun, PolarDaysHaveNoSunrise) {
    const auto json =
        noonmarkCli({"sun", "--lat", "78.2", "--lon", "15.6", "--at", "2026-06-21T12:00:00Z", "--json"})
            .json();
    EXPECT_TRUE(json["sunrise"].is_null());
    EXPECT_TRUE(json["sunset"].is_null());
    EXPECT_EQ(json["day_kind"], "polar day");
    EXPECT_THAT(json["transit"].get<std::string>(), StartsWith("2026-06-21T1"));
    EXPECT_THAT(json["transit"].get<std::string>(), HasSubstr("+00:00"));
}

TEST(Sun, TheCentreRisesLaterThanTheUpperLimb) {
    const auto limb = noonmarkCli(with(golden, {"--json"})).json();
    const auto centre = noonmarkCli(with(golden, {"--json", "--centre"})).json();
    EXPECT_LT(limb["sunrise"], centre["sunrise"]);
    EXPECT_GT(limb["sunset"], centre["sunset"]);
}

TEST(Sun, TableForPeople) {
    const CommandOutput output = noonmarkCli(golden);
    EXPECT_EQ(output.code, exitOk);
    EXPECT_THAT(output.out, HasSubstr("194.340"));
    EXPECT_THAT(output.out, HasSubstr("sunrise"));
    EXPECT_EQ(output.err, "");
}

TEST(Sun, WrongInput) {
    EXPECT_EQ(noonmarkCli({"sun", "--lat", "95", "--lon", "0", "--at", "2026-06-21T12:00:00Z"}).code,
              exitUsage);
    const CommandOutput noOffset =
        noonmarkCli({"sun", "--lat", "40", "--lon", "0", "--at", "2026-06-21T12:00:00"});
    EXPECT_EQ(noOffset.code, exitUsage);
    EXPECT_THAT(noOffset.err, HasSubstr("--zone"));
    EXPECT_EQ(noonmarkCli({"sun", "--lat", "40", "--lon", "0", "--at", "noon", "--zone", "UTC"}).code,
              exitUsage);
    EXPECT_EQ(noonmarkCli({"sun", "--lat", "40", "--lon", "0", "--at", "2026-06-31T12:00:00Z"}).code,
              exitUsage);
    EXPECT_EQ(noonmarkCli({"sun", "--lat", "nan", "--lon", "0", "--at", "2026-06-21T12:00:00Z"}).code,
              exitUsage);
    const CommandOutput antiquity =
        noonmarkCli({"sun", "--lat", "40", "--lon", "0", "--at", "0001-01-01T12:00:00Z"});
    EXPECT_EQ(antiquity.code, exitUsage);
    EXPECT_THAT(antiquity.err, HasSubstr("1900 to 2100"));
}

}  // namespace
}  // namespace noonmark::cli::tests
