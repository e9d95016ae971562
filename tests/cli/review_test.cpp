#include <fmt/format.h>

#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {

namespace {

using noonmark::tests::readBytes;
using testing::AllOf;
using testing::HasSubstr;

/// A project with the park as a place, a schoolyard, and a scenario in which a tower is gone.
class ReviewCommand : public ProjectCommand {
protected:
    void SetUp() override {
        ProjectCommand::SetUp();
        done("add-scenario", {"Without One57"});
        done("demolish", {"One57", "--scenario", "Without One57"});
        auto disk = ProjectFile::open(file_).value();
        Project project = disk.project();
        project.places.push_back({"Central Park", PlaceKind::park, project.regions.at(0).polygons, "test"});
        ASSERT_TRUE(disk.save(project));
    }

    CommandOutput review(const std::string& rule, std::vector<std::string> more) {
        std::vector<std::string> arguments{"review",
                                           "run",
                                           file_,
                                           "--rule",
                                           rule,
                                           "--from",
                                           "Without One57",
                                           "--to",
                                           "Existing",
                                           "--out",
                                           folder_.path("review").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    }

    const std::vector<std::string> all_{"--places", "all", "--zone",     "America/New_York",
                                        "--cell",   "10",  "--overwrite"};
};

TEST(ReviewRules, AreListedAndShownWithStatusAndSource) {
    const auto rules = noonmarkCli({"review", "list", "--json"}).json()["rules"];
    EXPECT_EQ(rules.size(), 27U);
    EXPECT_THAT(noonmarkCli({"review", "list"}).out,
                AllOf(HasSubstr("ceqr"), HasSubstr("not checked against")));
    const std::string shown = noonmarkCli({"review", "show", "ceqr"}).out;
    EXPECT_THAT(shown, AllOf(HasSubstr("03-21: 07:36 to 16:29"), HasSubstr("[U: Published windows"),
                             HasSubstr("<= 10 min [V]"), HasSubstr("Not checked")));
    EXPECT_THAT(noonmarkCli({"review", "show", "japan", "--choose", "plane=1.5 m"}).out,
                HasSubstr("plane 1.5 m above mean ground"));
    EXPECT_EQ(noonmarkCli({"review", "show", "own", "--json"}).json()["key"], "own");
    const CommandOutput none = noonmarkCli({"review", "show", "ceqrs"});
    EXPECT_EQ(none.code, 2);
    EXPECT_THAT(none.err, HasSubstr("'ceqr'"));
    EXPECT_EQ(noonmarkCli({"review", "show", "japan", "--choose", "plane"}).code, 2);
    EXPECT_EQ(noonmarkCli({"review", "list", "--rules", "/nowhere/at/all"}).code, 2);
}

TEST_F(ReviewCommand, WritesTheKeysThatScriptsRelyOn) {
    std::vector<std::string> asked = all_;
    asked.emplace_back("--json");
    const CommandOutput output = review("ceqr", asked);
    ASSERT_EQ(output.code, 0) << output.err;
    const auto json = output.json();
    EXPECT_EQ(json["rule"], "ceqr");
    EXPECT_EQ(json["from"], "Without One57");
    EXPECT_EQ(json["to"], "Existing");
    ASSERT_EQ(json["places"].size(), 1U);
    const auto place = json["places"][0];
    EXPECT_EQ(place["name"], "Central Park");
    EXPECT_EQ(place["kind"], "park");
    EXPECT_EQ(place["verdict"], "pass") << "a tower does not cover the whole park";
    ASSERT_EQ(place["rows"].size(), 4U);
    const auto december = place["rows"][3];
    EXPECT_EQ(december["day"], "2026-12-21");
    EXPECT_GT(december["duration_min"].get<double>(), 60);
    EXPECT_GE(december["duration_min"].get<double>(), december["max_point_min"].get<double>());
    EXPECT_GT(december["max_area_m2"].get<double>(), 1000);
    EXPECT_EQ(december["full_cover_min"], 0);
    EXPECT_GE(december["enters"].get<std::string>(), "08:51");
    EXPECT_LE(december["exits"].get<std::string>(), "14:53");
    EXPECT_GE(json["not_checked"].size(), 4U);
    EXPECT_EQ(json["scenario"], "Existing");
    EXPECT_EQ(nlohmann::json::parse(readBytes(folder_.path("review/review.json"))), json);
    EXPECT_THAT(readBytes(folder_.path("review/review.csv")),
                AllOf(HasSubstr("rule,from,to,place,kind,verdict,day"), HasSubstr("2026-12-21")));
}

TEST_F(ReviewCommand, MayKeepToThePlacesInReach) {
    // A square 700 m south of the tower, where no shadow falls in New York.
    auto disk = ProjectFile::open(file_).value();
    Project project = disk.project();
    const Ring square{{0, -700}, {50, -700}, {50, -650}, {0, -650}};
    project.places.push_back({"Far Square", PlaceKind::park, {{square, {}}}, "test"});
    ASSERT_TRUE(disk.save(project));
    const auto namesOf = [](const CommandOutput& output) {
        std::vector<std::string> names;
        const auto json = output.json();
        for (const auto& place : json["places"]) names.push_back(place["name"]);
        return names;
    };
    std::vector<std::string> asked = all_;
    asked.emplace_back("--json");
    EXPECT_THAT(namesOf(review("ceqr", asked)), testing::ElementsAre("Central Park", "Far Square"));
    asked.emplace_back("--in-reach");
    const CommandOutput near = review("ceqr", asked);
    ASSERT_EQ(near.code, 0) << near.err;
    EXPECT_THAT(namesOf(near), testing::ElementsAre("Central Park"));
    EXPECT_THAT(near.json()["repeat"].get<std::string>(), HasSubstr("--in-reach"));
    EXPECT_THAT(near.json()["warnings"].dump(),
                AllOf(HasSubstr("does not reach it"), HasSubstr("Far Square")));
    asked[1] = "Far Square";
    EXPECT_THAT(review("ceqr", asked).err, HasSubstr("reaches no place"));
}

TEST_F(ReviewCommand, WritesABookOfSheets) {
    std::vector<std::string> asked = all_;
    asked.insert(asked.end(), {"--paper", "a3", "--landscape", "--scale", "2000", "--author", "A. Planner"});
    const CommandOutput output = review("ceqr", asked);
    ASSERT_EQ(output.code, 0) << output.err;
    const std::string pdf = readBytes(folder_.path("review/sheets.pdf"));
    EXPECT_THAT(pdf, testing::StartsWith("%PDF-"));
    EXPECT_GT(pdf.size(), 50'000U);
    asked = all_;
    asked.insert(asked.end(), {"--paper", "A0"});
    EXPECT_EQ(review("ceqr", asked).code, 2);
    asked = all_;
    asked.insert(asked.end(), {"--logo", "/nowhere/logo.png"});
    EXPECT_EQ(review("ceqr", asked).code, 2);
}

TEST_F(ReviewCommand, ReviewsTheExistingCityWithoutAScenario) {
    const CommandOutput output =
        noonmarkCli({"review", "run", file_, "--rule", "bre-209-amenity", "--places", "all", "--zone",
                     "America/New_York", "--cell", "10", "--out", folder_.path("review").string(), "--json"});
    ASSERT_EQ(output.code, 0) << output.err;
    const auto json = output.json();
    EXPECT_EQ(json["from"], "Existing");
    EXPECT_EQ(json["to"], "Existing");
    EXPECT_EQ(json["places"][0]["verdict"], "pass");
    EXPECT_GT(json["places"][0]["totals"]["scenario_m2h"], 0);
    EXPECT_EQ(json["places"][0]["totals"]["incremental_m2h"], 0);
}

TEST_F(ReviewCommand, MayLayACopyOfTheProjectBesideItsFiles) {
    std::vector<std::string> asked = all_;
    asked.emplace_back("--with-project");
    ASSERT_EQ(review("four-days", asked).code, 0);
    const auto copy = folder_.path("review") / std::filesystem::path(file_).filename();
    EXPECT_TRUE(std::filesystem::exists(copy));
    const CommandOutput verified = noonmarkCli({"verify", folder_.path("review/sheets.pdf").string()});
    EXPECT_EQ(verified.code, 0) << verified.out << verified.err;
    EXPECT_EQ(review("four-days", asked).code, 0) << "the same copy is left as it is";
    std::ofstream(copy) << "another";
    EXPECT_THAT(review("four-days", asked).err, HasSubstr("Another file has the name"));
}

TEST_F(ReviewCommand, PrintsTheRulesOwnTableAndWhatIsNotChecked) {
    const CommandOutput output = review("ceqr", all_);
    ASSERT_EQ(output.code, 0) << output.err;
    EXPECT_THAT(output.out, AllOf(HasSubstr("Incremental shadow enters"), HasSubstr("Central Park: pass."),
                                  HasSubstr("Not checked"), HasSubstr("standard time")));
    std::vector<std::string> again = all_;
    again.pop_back();
    EXPECT_THAT(review("ceqr", again).err, HasSubstr("review.json"));
}

TEST_F(ReviewCommand, MeasuresTheBeltsAroundALot) {
    const CommandOutput output =
        review("japan", {"--places", "One57", "--zone", "America/New_York", "--cell", "5", "--json"});
    ASSERT_EQ(output.code, 0) << output.err;
    const auto places = output.json()["places"];
    ASSERT_EQ(places.size(), 2U);
    EXPECT_EQ(places[0]["name"], "One57, 5 to 10 m");
    EXPECT_EQ(places[0]["verdict"], "fail");
    EXPECT_EQ(places[1]["verdict"], "fail");
}

TEST_F(ReviewCommand, RefusesWhatItDoesNotKnow) {
    EXPECT_EQ(review("none", all_).code, 2);
    EXPECT_EQ(review("ceqr", {"--places", "Nowhere", "--zone", "America/New_York"}).code, 2);
    const CommandOutput noZone = review("ceqr", {"--places", "all"});
    EXPECT_EQ(noZone.code, 2);
    EXPECT_THAT(noZone.err, HasSubstr("--zone"));
    EXPECT_EQ(review("ceqr", {"--places", "all", "--zone", "Atlantis"}).code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder_.path("review/review.json")));
}

TEST_F(ReviewCommand, EvaluatesWindowsOfFacades) {
    const std::vector<std::string> facades{"--facades-of", "all",
                                           "--region",     "-73.9800,40.7645,-73.9780,40.7660",
                                           "--bay",        "15",
                                           "--storey",     "30",
                                           "--zone",       "America/New_York",
                                           "--json",       "--overwrite"};
    const CommandOutput output = review("korea", facades);
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    EXPECT_EQ(json["rule"], "korea");
    ASSERT_GT(json["windows"].size(), 20U);
    const auto& first = json["windows"][0];
    for (const char* key : {"id", "building", "floor", "azimuth_deg", "verdict", "verdict_before", "bands",
                            "bands_before", "criteria"})
        EXPECT_TRUE(first.contains(key)) << key;
    const auto& counts = json["counts"]["windows"]["after"];
    EXPECT_EQ(std::size_t(counts["pass"]) + std::size_t(counts["borderline"]) + std::size_t(counts["fail"]),
              json["windows"].size());
    EXPECT_THAT(std::string(json["repeat"]), HasSubstr("--facades-of all"));
    const std::string csv = readBytes(folder_.path("review") / "windows.csv");
    EXPECT_THAT(csv,
                testing::StartsWith("id,building,building_name,floor,azimuth_deg,windows,total_before,"));
    EXPECT_EQ(std::size_t(std::ranges::count(csv, '\n')), json["windows"].size() + 1);
    const std::string layer = readBytes(folder_.path("review") / "windows.gpkg");
    EXPECT_THAT(layer, HasSubstr(R"(type="categorizedSymbol" attr="verdict_after")"));
    EXPECT_THAT(layer, HasSubstr(R"(category value="borderline")"));
    EXPECT_THAT(readBytes(folder_.path("review") / "sheets.pdf"), testing::StartsWith("%PDF"));
    std::vector<std::string> byHorizons = facades;
    byHorizons.insert(byHorizons.end(), {"--engine", "horizon"});
    const CommandOutput swept = review("korea", byHorizons);
    for (std::size_t i = 0; i < json["windows"].size(); ++i)
        EXPECT_EQ(swept.json()["windows"][i]["verdict"], json["windows"][i]["verdict"]) << i;
}

/// City files with a house and a tower south of it, in Amsterdam's degrees.
class ReviewOfFiles : public testing::Test {
protected:
    CommandOutput review(std::vector<std::string> more) {
        std::vector<std::string> arguments{
            "review",       "run", city_,    "--rule",           "korea", "--out", out_,
            "--facades-of", "a",   "--zone", "Europe/Amsterdam", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    }
    noonmark::tests::TemporaryFolder folder_;
    std::string city_ = folder_
                            .file("city.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"id":"a","height":12},"geometry":{"type":"Polygon","coordinates":
[[[4.9,52.37],[4.9003,52.37],[4.9003,52.3702],[4.9,52.3702],[4.9,52.37]]]}},
{"type":"Feature","properties":{"id":"b","height":60},"geometry":{"type":"Polygon","coordinates":
[[[4.9,52.3696],[4.9003,52.3696],[4.9003,52.3698],[4.9,52.3698],[4.9,52.3696]]]}}]})")
                            .string();
    std::string out_ = folder_.path("review").string();
};

TEST_F(ReviewOfFiles, AreTheVerdictsOfAProjectOfTheSameFiles) {
    const CommandOutput files = review({});
    ASSERT_EQ(files.code, 0) << files.err;
    const auto json = files.json();
    ASSERT_GT(json["windows"].size(), 20U);
    EXPECT_EQ(json["from"], "Existing");
    EXPECT_EQ(json["counts"]["windows"]["worse"], 0);
    const std::string repeat = json["repeat"];
    EXPECT_THAT(repeat, AllOf(HasSubstr("review run city.geojson"), HasSubstr("--facades-of a")));
    EXPECT_THAT(repeat, testing::Not(HasSubstr("--to")));
    const std::string project = folder_.path("city.noonmark.gpkg").string();
    ASSERT_EQ(noonmarkCli({"project", "new", project, city_}).code, 0);
    const CommandOutput of = noonmarkCli({"review", "run", project, "--rule", "korea", "--to", "Existing",
                                          "--out", folder_.path("other").string(), "--facades-of", "a",
                                          "--zone", "Europe/Amsterdam", "--json"});
    ASSERT_EQ(of.code, 0) << of.err;
    EXPECT_EQ(of.json()["windows"], json["windows"]);
}

TEST_F(ReviewOfFiles, StateTheTimeWithoutWritingAnything) {
    const CommandOutput estimate = review({"--estimate"});
    ASSERT_EQ(estimate.code, 0) << estimate.err;
    const auto json = estimate.json();
    EXPECT_GT(json["estimated_seconds"].get<double>(), 0);
    EXPECT_FALSE(std::filesystem::exists(out_));
    EXPECT_EQ(json["windows"], review({}).json()["windows"].size());
}

TEST_F(ReviewOfFiles, NeedAFolderOnlyForFiles) {
    std::vector<std::string> asked{"review",       "run", city_,    "--rule",          "korea",
                                   "--facades-of", "a",   "--zone", "Europe/Amsterdam"};
    const CommandOutput without = noonmarkCli(asked);
    EXPECT_EQ(without.code, 2);
    EXPECT_THAT(without.err, HasSubstr("Give --out DIR"));
    asked.emplace_back("--estimate");
    EXPECT_EQ(noonmarkCli(asked).code, 0);
}

TEST_F(ReviewOfFiles, RepeatTheTextsOfTheTitleBlock) {
    const CommandOutput titled = review({"--title-project", "Mill House"});
    ASSERT_EQ(titled.code, 0) << titled.err;
    EXPECT_THAT(std::string(titled.json()["repeat"]), HasSubstr("--title-project 'Mill House'"));
}

TEST_F(ReviewOfFiles, HaveNoScenariosPlacesOrProjectsBeside) {
    EXPECT_THAT(review({"--to", "Proposal"}).err, HasSubstr("Only a project has scenarios"));
    const CommandOutput places = noonmarkCli({"review", "run", city_, "--rule", "ceqr", "--places", "all",
                                              "--zone", "Europe/Amsterdam", "--out", out_});
    EXPECT_EQ(places.code, 2);
    EXPECT_THAT(places.err, HasSubstr("reviewed in a project"));
}

TEST_F(ReviewCommand, PrintsTheSumsOfRulesAboutManyDays) {
    const CommandOutput output = review("san-francisco-295", all_);
    ASSERT_EQ(output.code, 0) << output.err;
    EXPECT_THAT(output.out, AllOf(HasSubstr("Sums over the 365 days of the rule:"),
                                  HasSubstr("  Central Park: shadow existing "),
                                  HasSubstr("; most incremental shadow on ")));
    EXPECT_THAT(review("ceqr", all_).out, testing::Not(HasSubstr("Sums over")));
}

TEST_F(ReviewCommand, EvaluatesTheWindowsOfAFileAndVerifiesTheReview) {
    // High above the streets: south of One57, without a wall, and in the ground.
    const std::string windows = folder_
                                    .file("windows.geojson", R"({"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"id":"high","azimuth":180},"geometry":{"type":"Point","coordinates":[-73.9791,40.7640,290]}},
{"type":"Feature","properties":{"id":"low","azimuth":180},"geometry":{"type":"Point","coordinates":[-73.9791,40.7640,-3]}}]})")
                                    .string();
    const CommandOutput output = review("tno-light", {"--windows", windows, "--zone", "America/New_York",
                                                      "--wall", "0.2", "--overwrite", "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto json = output.json();
    ASSERT_EQ(json["windows"].size(), 1U) << "the one below the ground is left out";
    EXPECT_EQ(json["windows"][0]["id"], "high");
    EXPECT_EQ(json["windows"][0]["verdict"], "pass");
    EXPECT_EQ(json["windows_file"][0]["path"], windows);
    EXPECT_THAT(std::string(json["repeat"]), HasSubstr("--windows windows.geojson"));
    const CommandOutput verified = noonmarkCli(
        {"verify", folder_.path("review/review.json").string(), "--inputs", folder_.path("").string()});
    EXPECT_EQ(verified.code, exitOk) << verified.out << verified.err;
}

TEST_F(ReviewCommand, RefusesWindowsWherePlacesBelongAndTheReverse) {
    const std::vector<std::string> zone{"--zone", "America/New_York"};
    const auto error = [&](const std::string& rule, std::vector<std::string> more) {
        more.insert(more.end(), zone.begin(), zone.end());
        const CommandOutput output = review(rule, more);
        EXPECT_EQ(output.code, exitUsage);
        return output.err;
    };
    EXPECT_THAT(error("korea", {"--places", "all"}), HasSubstr("about windows"));
    EXPECT_THAT(error("korea", {}), HasSubstr("--facades-of"));
    EXPECT_THAT(error("ceqr", {"--facades-of", "One57"}), HasSubstr("about places"));
    EXPECT_THAT(error("korea", {"--places", "all", "--facades-of", "One57"}),
                HasSubstr("not reviewed together"));
    EXPECT_THAT(error("korea", {"--facades-of", "Nowhere House"}), HasSubstr("no building"));
    EXPECT_THAT(error("korea", {"--windows", "nowhere.gpkg"}), HasSubstr("nowhere.gpkg"));
    EXPECT_THAT(error("korea", {"--facades-of", "One57", "--sunshine",
                                "0.2,0.2,0.2,0.2,0.2,0.2,0.2,0.2,0.2,0.2,0.2,0.2"}),
                HasSubstr("no probable sunlight"));
}

}  // namespace

}  // namespace noonmark::cli::tests
