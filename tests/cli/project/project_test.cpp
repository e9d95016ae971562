#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string formatText(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(ProjectCommand, AWholeStudy) {
    ASSERT_EQ(project("add-scenario", {"Before"}).code, 0);
    ASSERT_EQ(project("demolish", {"One57", "432 Park Avenue", "--scenario", "Before"}).code, 0);
    const CommandOutput impact = atNoon("impact", {"--from", "Before", "--to", "Existing", "--by-building",
                                                   "--json", "--threshold", "5", "20", "--keep", "towers"});
    ASSERT_EQ(impact.code, 0) << impact.err;
    const auto json = impact.json();
    ASSERT_EQ(json["impact"].size(), 2U);
    EXPECT_GT(json["impact"][0]["gross"]["gained_m2"].get<double>(), 1000);
    EXPECT_GT(json["impact"][0]["gross"]["gained_m2"], json["impact"][1]["gross"]["gained_m2"]);
    EXPECT_EQ(json["impact"][0]["gross"]["lost_m2"], 0);
    ASSERT_EQ(json["by_building"].size(), 2U);
    EXPECT_EQ(json["by_building"][0]["id"], "One57");
    EXPECT_EQ(formatText(folder_.path("out/impact.json")) + "\n", impact.out);
    EXPECT_THAT(formatText(folder_.path("out/impact.csv")),
                AllOf(HasSubstr("id,name,threshold_min"), HasSubstr("\r\nOne57,One57,20,")));
    for (const char* file : {"out/impact.tif", "out/impact.png", "out/impact.pdf"})
        EXPECT_GT(std::filesystem::file_size(folder_.path(file)), 1000U) << file;
    ASSERT_EQ(opened().results.size(), 1U);
    EXPECT_EQ(opened().results[0]->baseline, "Before");
}

TEST_F(ProjectCommand, TowersAreBuiltAndReshaped) {
    ASSERT_EQ(project("add-scenario", {"A"}).code, 0);
    ASSERT_EQ(project("demolish", {"520 Park Avenue", "--scenario", "A"}).code, 0);
    const CommandOutput built = project(
        "extrude", {"--scenario", "A", "--lot", "520 Park Avenue", "--id", "New tower", "--storeys", "40",
                    "--storey-height", "4", "--plate-share", "50", "--podium", "5", "--setback", "80:2"});
    ASSERT_EQ(built.code, 0) << built.err;
    EXPECT_THAT(built.out, HasSubstr("New tower: 40 storeys, 160.0 m"));
    ASSERT_EQ(project("add-scenario", {"B", "--base", "A"}).code, 0);
    const CommandOutput wider = project("variant", {"One57", "520 Park Avenue", "--scenario", "B"});
    EXPECT_EQ(wider.code, 2);  // 520 Park Avenue was demolished
    EXPECT_THAT(wider.err, HasSubstr("There is no such building"));
    const CommandOutput variant = project("variant", {"One57", "--scenario", "B"});
    ASSERT_EQ(variant.code, 0) << variant.err;
    EXPECT_THAT(variant.out, HasSubstr("One57: 306.1 m -> 44 storeys, 154.0 m"));
    const auto city = cityOf(opened(), "B").value();
    EXPECT_EQ(city.changes.added.size(), 2U);
    const CommandOutput info = project("info", {"--json"});
    EXPECT_EQ(info.json()["scenarios"][1]["base"], "A");
    const auto out = folder_.path("b.gpkg").string();
    EXPECT_EQ(project("export", {"--scenario", "B", "--out", out}).code, 0);
    EXPECT_THAT(noonmarkCli({"info", out}).out, HasSubstr("buildings"));
}

TEST_F(ProjectCommand, InfoReadsAProjectAsAProject) {
    const CommandOutput info = noonmarkCli({"info", file_, "--json"});
    ASSERT_EQ(info.code, 0) << info.err;
    EXPECT_EQ(info.json()["format"], "Noonmark project");
    EXPECT_EQ(info.json()["buildings"], opened().city->buildings.size());
    EXPECT_THAT(noonmarkCli({"info", file_}).out, HasSubstr("noonmark-cli project info"));
    EXPECT_THAT(noonmarkCli({"info", file_, "--height-field", "height"}).err,
                HasSubstr("has already been read"));
    EXPECT_THAT(noonmarkCli({"info", file_, folder_.path("dem.tif").string()}).err,
                HasSubstr("cannot be combined"));
}

TEST_F(ProjectCommand, TablesNameTheProject) {
    ASSERT_EQ(project("add-scenario", {"A"}).code, 0);
    const CommandOutput study =
        measured("study", {"--scenario", "A", "--start", "2026-12-21", "--from", "12:00", "--hours", "1",
                           "--step", "10", "--zone", "America/New_York", "--by", "month", "--contributions",
                           "--engine", "horizon"});
    ASSERT_EQ(study.code, 0) << study.err;
    for (const char* name : {"out/by_month.csv", "out/contributions.csv"})
        EXPECT_THAT(formatText(folder_.path(name)), HasSubstr(",park.noonmark.gpkg,A,,")) << name;
}

TEST_F(ProjectCommand, IsKnownByWhatItHolds) {
    const std::filesystem::path copy = folder_.path("another name.gpkg");
    std::filesystem::copy_file(file_, copy);
    const CommandOutput info = noonmarkCli({"info", copy.string(), "--json"});
    ASSERT_EQ(info.code, 0) << info.err;
    EXPECT_EQ(info.json()["format"], "Noonmark project");
}

TEST_F(ProjectCommand, MapAndPictureNameTheProject) {
    ASSERT_EQ(project("add-scenario", {"A"}).code, 0);
    ASSERT_EQ(project("demolish", {"520 Park Avenue", "--scenario", "A"}).code, 0);
    const CommandOutput study =
        measured("study", {"--scenario", "A", "--start", "2026-12-21", "--from", "12:00", "--hours", "1",
                           "--step", "10", "--zone", "America/New_York"});
    ASSERT_EQ(study.code, 0) << study.err;
    for (const char* name : {"out/shadow.tif", "out/shadow.png"}) {
        const std::string bytes = formatText(folder_.path(name));
        EXPECT_THAT(bytes, HasSubstr("park.noonmark.gpkg")) << name;
        EXPECT_THAT(bytes, HasSubstr("NOONMARK_SCENARIO_CITY_SHA256")) << name;
        EXPECT_THAT(bytes, HasSubstr("520 Park Avenue")) << name;
    }
}

TEST_F(ProjectCommand, ScoresAYear) {
    const CommandOutput score = atNoon("score", {"--days", "365", "--weights", "default", "--json"});
    ASSERT_EQ(score.code, 0) << score.err;
    EXPECT_EQ(score.json()["months"].size(), 13U);  // 21 December to 20 December: December appears twice
    EXPECT_LT(score.json()["score_m2"].get<double>(), 0);
    EXPECT_THAT(formatText(folder_.path("out/score.csv")), HasSubstr("2026-12,"));
}

TEST_F(ProjectCommand, MistakesAreReportedAndNothingIsSaved) {
    EXPECT_EQ(noonmarkCli({"project", "new", file_, "sample:central-park-south"}).code, 2);
    EXPECT_THAT(project("demolish", {"One57", "--scenario", "Existing"}).err,
                HasSubstr("The existing city cannot be changed"));
    EXPECT_THAT(project("demolish", {"One57", "--scenario", "B"}).err,
                HasSubstr("The project has no scenario yet"));
    ASSERT_EQ(project("add-scenario", {"A"}).code, 0);
    EXPECT_THAT(project("demolish", {"One57", "--scenario", "B"}).err,
                HasSubstr("There is no such scenario"));
    EXPECT_THAT(project("moves", {}).err, HasSubstr("There is no command 'project moves'"));
    EXPECT_THAT(noonmarkCli({"project", "lot", "sell"}).err,
                HasSubstr("There is no command 'project lot sell'"));
    EXPECT_EQ(project("add-scenario", {"A"}).code, 2);
    EXPECT_EQ(project("demolish", {"One57", "nothing", "--scenario", "A"}).code, 2);
    EXPECT_THAT(project("extrude", {"--scenario", "A", "--lot", "One57", "--id", "x", "--storeys", "9",
                                    "--setback", "9"})
                    .err,
                HasSubstr("HEIGHT:INSET"));
    EXPECT_THAT(project("variant", {"One57", "--scenario", "A", "--plate", "0"}).err, HasSubstr("largest"));
    EXPECT_TRUE(opened().scenarios[0].edits.empty());
    EXPECT_THAT(atNoon("impact", {"--to", "C"}).err, HasSubstr("There is no such scenario"));
    EXPECT_THAT(atNoon("score", {"--weights", "mine"}).err, HasSubstr("'default'"));
    EXPECT_EQ(noonmarkCli({"project", "info", folder_.path("gone").string()}).code, 2);
}

}  // namespace
}  // namespace noonmark::cli::tests
