#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {
namespace {

using testing::HasSubstr;

double sumOf(const nlohmann::json& numbers) {
    double sum = 0;
    for (const auto& number : numbers) sum += number.get<double>();
    return sum;
}

std::vector<std::string> pointOf(const std::string& file, const std::string& at,
                                 std::vector<std::string> more) {
    std::vector<std::string> arguments{"point", file,         "--at",  at, "--zone", "America/New_York",
                                       "--day", "2026-12-21", "--json"};
    if (std::ranges::find(more, "--step") == more.end()) more.insert(more.end(), {"--step", "5"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Point, CountsWarningsAndListsAFewPlacesOrAllOnRequest) {
    const noonmark::tests::TemporaryFolder folder;
    std::string features;
    for (int i = 0; i < 5; ++i) {  // squares of 20 m without a height, 40 m apart
        const double west = -73.98 + i * 4.7e-4, east = west + 2.4e-4;
        features += fmt::format(
            R"({}{{"type":"Feature","properties":{{}},"geometry":{{"type":"Polygon","coordinates":)"
            R"([[[{:.6f},40.7],[{:.6f},40.7],[{:.6f},40.7002],[{:.6f},40.7002],[{:.6f},40.7]]]}}}})",
            i == 0 ? "" : ",", west, east, east, west, west);
    }
    const std::string file = folder.path("bare.geojson").string();
    std::ofstream(file) << R"({"type":"FeatureCollection","features":[)" << features << "]}";
    const auto assumed = [&](std::vector<std::string> more) {
        const CommandOutput output = noonmarkCli(pointOf(file, "-73.98,40.699", std::move(more)));
        EXPECT_EQ(output.code, exitOk) << output.err;
        const auto json = output.json();
        for (const auto& warning : json["warnings"])
            if (warning["what"].get<std::string>().find("no height") != std::string::npos) return warning;
        return nlohmann::json();
    };
    const auto few = assumed({}), all = assumed({"--all-warnings"});
    EXPECT_EQ(few.at("count"), 5);
    EXPECT_EQ(few.at("where").size(), 3U);
    EXPECT_EQ(all.at("count"), 5);
    EXPECT_EQ(all.at("where").size(), 5U);
}

TEST(Point, TheDrawingIsNotWrittenOverTheTable) {
    const noonmark::tests::TemporaryFolder folder;
    const std::string file = folder.path("sky").string(), again = folder.path("./sky").string();
    const CommandOutput output = noonmarkCli(
        pointOf("sample:central-park-south", "-73.9785,40.7675,1.5", {"--svg", file, "--csv", again}));
    EXPECT_NE(output.code, exitOk);
    EXPECT_THAT(output.err, HasSubstr("Name two files"));
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Point, HasTheKeysThatScriptsRelyOn) {
    const CommandOutput output =
        noonmarkCli(pointOf("sample:central-park-south", "-73.9785,40.7675,1.5", {"--facing", "180"}));
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    EXPECT_EQ(json["skyline"].front()[0], 0);
    EXPECT_EQ(json["skyline"].back()[0], 360);
    for (const auto& pair : json["skyline"]) {
        EXPECT_GE(pair[1], 0);
        EXPECT_LT(pair[1], 90);
    }
    for (const auto& band : json["sunlit"]) {
        EXPECT_THAT(band["from"].get<std::string>(), testing::StartsWith("2026-12-21T"));
        EXPECT_LT(band["from"], band["to"]);
    }
    ASSERT_EQ(json["minutes_by_month"].size(), 12U);
    for (std::size_t month = 0; month < 12; ++month)
        EXPECT_NEAR(sumOf(json["minutes_by_month_and_hour"][month]), json["minutes_by_month"][month], 1.5);
    EXPECT_GT(json["svf"], 0);
    EXPECT_LT(json["svf"], 0.5);  // a wall
    EXPECT_LT(json["vsc_pct"], 39.62);
    EXPECT_THAT(json["sentence"].get<std::string>(), testing::StartsWith("On 21 December this point gets "));
}

// The ends of sunlight do not depend on the step that the year is measured with.
TEST(Point, TimesOfTheDayAreExactAtAnyStep) {
    const std::string place = "-73.9785,40.7675,1.5";
    const auto fine = noonmarkCli(pointOf("sample:central-park-south", place, {"--step", "0.25"})).json();
    const auto coarse = noonmarkCli(pointOf("sample:central-park-south", place, {"--step", "15"})).json();
    ASSERT_GT(fine["sunlit"].size(), 0U);
    ASSERT_EQ(coarse["sunlit"].size(), fine["sunlit"].size());
    for (std::size_t i = 0; i < fine["sunlit"].size(); ++i)
        EXPECT_NEAR(coarse["sunlit"][i]["minutes"], fine["sunlit"][i]["minutes"], 0.02);
    double allDay = 0;
    for (const char* kind : {"sunlit", "shaded"})
        for (const auto& time : coarse[kind]) allDay += time["minutes"].get<double>();
    EXPECT_NEAR(allDay, 9 * 60 + 15,
                5);  // New York's shortest day, centre of the sun above the horizon: 9:08 to 9:15
    EXPECT_NE(coarse["shaded"][0]["building"], "");
    std::string end, building;
    for (const auto& time : coarse["shaded"]) {
        EXPECT_LE(end, time["from"]) << "no time counts twice";
        EXPECT_FALSE(end == time["from"] && building == time["building"]) << "an unbroken time is one";
        end = time["to"], building = time["building"];
    }
    EXPECT_GT(coarse["error"]["year_min"], fine["error"]["year_min"]);
}

TEST(Point, InTheOpenAllTheSkyIsSeen) {
    const CommandOutput output =
        noonmarkCli(pointOf("sample:central-park-south", "-73.9785,40.7675,2000", {}));
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    EXPECT_NEAR(json["svf"], 1, 1e-5);
    EXPECT_FALSE(json.contains("vsc_pct"));
    EXPECT_EQ(json["sunlit"].size(), 1U);
    EXPECT_EQ(json["skyline_buildings"].size(), 0U);
}

TEST(Point, DrawsItsSky) {
    const noonmark::tests::TemporaryFolder folder;
    const std::string file = folder.path("sky.svg").string();
    const auto draw = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"--facing", "180", "--svg", file});
        return noonmarkCli(pointOf("sample:central-park-south", "-73.9785,40.7675,1.5", more));
    };
    ASSERT_EQ(draw({}).code, exitOk);
    std::ifstream stream(file);
    const std::string svg((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    EXPECT_THAT(svg, testing::StartsWith("<svg xmlns="));
    EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
    EXPECT_THAT(svg, HasSubstr("degrees</text>"));  // a building of the legend
    EXPECT_THAT(svg, HasSubstr("behind the wall"));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(draw({}).code, exitUsage);  // it exists
    EXPECT_EQ(draw({"--overwrite"}).code, exitOk);
}

TEST(Point, WritesItsMinutesByMonthAndHour) {
    const noonmark::tests::TemporaryFolder folder;
    const std::string file = folder.path("sun.csv").string();
    const CommandOutput output =
        noonmarkCli(pointOf("sample:central-park-south", "-73.9785,40.7675,1.5", {"--csv", file}));
    ASSERT_EQ(output.code, exitOk) << output.err;
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    EXPECT_EQ(line, "month,hour,baseline_min\r");
    double sum = 0;
    int lines = 0;
    for (; std::getline(stream, line); ++lines) sum += std::stod(line.substr(line.rfind(',') + 1));
    EXPECT_EQ(lines, 12 * 24);
    EXPECT_NEAR(sum, sumOf(output.json()["minutes_by_month"]), 12);  // whole minutes there
}

TEST(Point, RefusesWhatIsNoPoint) {
    EXPECT_EQ(noonmarkCli(pointOf("sample:central-park-south", "-73.9785", {})).code, exitUsage);
    EXPECT_EQ(noonmarkCli(pointOf("sample:central-park-south", "-73.9785,140", {})).code, exitUsage);
    EXPECT_EQ(noonmarkCli(pointOf("sample:central-park-south", "-73.9785,40.7675,x", {})).code, exitUsage);
    EXPECT_EQ(noonmarkCli(pointOf("sample:central-park-south", "-73.9785,40.7675,-3", {})).code, exitUsage);
    const CommandOutput scenario =
        noonmarkCli(pointOf("sample:central-park-south", "-73.9785,40.7675", {"--scenario", "Tower"}));
    EXPECT_EQ(scenario.code, exitUsage);
    EXPECT_THAT(scenario.err, HasSubstr("Only a project has scenarios"));
}

/// A project with a scenario in which a tower is gone: the existing city is the proposal.
class PointOfProject : public ProjectCommand {
protected:
    void SetUp() override {
        ProjectCommand::SetUp();
        done("add-scenario", {"Before"});
        done("demolish", {"One57", "--scenario", "Before"});
    }
};

TEST_F(PointOfProject, StatesWhatTheProposalTakes) {
    const std::string at = "-73.9785,40.7675";
    const CommandOutput output =
        noonmarkCli(pointOf(file_, at, {"--baseline", "Before", "--scenario", "Existing"}));
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    EXPECT_LT(sumOf(json["scenario"]["minutes_by_month"]), sumOf(json["minutes_by_month"]));
    EXPECT_LT(json["scenario"]["svf"], json["svf"]);
    EXPECT_THAT(json["sentence"].get<std::string>(),
                testing::MatchesRegex("The proposal takes .* mostly .*"));
    const CommandOutput same = noonmarkCli(pointOf(file_, at, {"--scenario", "Existing"}));
    EXPECT_EQ(same.json()["sentence"], "The proposal takes no sun from this point on any day of the year.");
}

// The season's first and last days lose only minutes, which steps of a quarter of an hour would miss.
TEST_F(PointOfProject, TheSeasonDoesNotDependOnTheStep) {
    const auto sentence = [&](const char* step) {
        return noonmarkCli(pointOf(file_, "-73.9785,40.7675",
                                   {"--baseline", "Before", "--scenario", "Existing", "--step", step}))
            .json()["sentence"];
    };
    EXPECT_EQ(sentence("15"), sentence("1"));
}

TEST_F(PointOfProject, ComparesAnyTwoScenariosAndListsAll) {
    const std::string at = "-73.9785,40.7675";
    const auto one =
        noonmarkCli(pointOf(file_, at, {"--against", "Before", "--scenario", "Existing"})).json();
    const auto other =
        noonmarkCli(pointOf(file_, at, {"--against", "Existing", "--scenario", "Before"})).json();
    EXPECT_EQ(one["scenario"]["minutes_by_month"], other["minutes_by_month"]);
    const CommandOutput all = noonmarkCli(pointOf(file_, at, {"--all-scenarios"}));
    ASSERT_EQ(all.code, exitOk) << all.err;
    const auto scenarios = all.json()["scenarios"];
    ASSERT_EQ(scenarios.size(), 2U);
    EXPECT_EQ(scenarios[0]["name"], "Existing");
    EXPECT_EQ(scenarios[1]["name"], "Before");
    EXPECT_NEAR(scenarios[0]["year_min"].get<double>(), sumOf(all.json()["minutes_by_month"]), 1);
    EXPECT_LT(scenarios[0]["year_min"], scenarios[1]["year_min"]) << "the tower takes sun";
    EXPECT_EQ(noonmarkCli({"point", "sample:grid", "--at", at, "--all-scenarios"}).code, exitUsage);
}

}  // namespace
}  // namespace noonmark::cli::tests
