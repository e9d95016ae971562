#include <fstream>

#include "core/io/write_raster.h"
#include "core/study/tile_tasks/plan/task_plan.h"
#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {
namespace {

using noonmark::tests::readBytes;
using testing::HasSubstr;

const std::vector<std::string> noon{"--cell", "10", "--start", "2026-12-21",       "--hours",  "1",
                                    "--step", "10", "--zone",  "America/New_York", "--engine", "projected"};

/// The project in tiles.
class ProjectTiles : public ProjectCommand {
protected:
    [[nodiscard]] CommandOutput plan(const std::vector<std::string>& more) const {
        std::vector<std::string> words{"tiles", "plan",  file_,    "--region", "Park", "--from",
                                       "12:00", "--out", planned_, "--tile",   "64",   "--json"};
        words.insert(words.end(), noon.begin(), noon.end());
        words.insert(words.end(), more.begin(), more.end());
        return noonmarkCli(words);
    }
    void runAndMerge(std::size_t tasks) const {
        for (std::size_t task = 0; task < tasks; ++task) {
            const CommandOutput ran = noonmarkCli({"tiles", "run", planned_, "--task", std::to_string(task)});
            ASSERT_EQ(ran.code, 0) << ran.err;
        }
        const CommandOutput merged = noonmarkCli({"tiles", "merge", planned_});
        ASSERT_EQ(merged.code, 0) << merged.err;
    }
    /// `command` measures what the plan does.
    void expectEqualMaps(const std::string& command, std::vector<std::string> more) {
        more.insert(more.end(), {"--at", "12:00"});
        more.insert(more.end(), noon.begin(), noon.end());
        more.insert(more.end(), {"--region", "Park", "--out", folder_.path("out").string()});
        more.insert(more.begin(), {command, file_});
        const CommandOutput output = noonmarkCli(more);
        ASSERT_EQ(output.code, 0) << output.err;
        const Grid grid = readTaskPlan(planned_).value().districts[0].tiles.whole;
        const auto whole = readGeoTiff(folder_.path("out/" + command + ".tif"), grid).value();
        const auto tiled = readGeoTiff(folder_.path("plan/merged/" + command + ".tif"), grid).value();
        ASSERT_EQ(whole.size(), tiled.size());
        for (std::size_t band = 0; band < whole.size(); ++band)
            for (std::size_t i = 0; i < whole[band].size(); ++i)
                ASSERT_TRUE(whole[band][i] == tiled[band][i] ||
                            (std::isnan(whole[band][i]) && std::isnan(tiled[band][i])))
                    << band << ' ' << i;
    }

    std::string planned_ = folder_.path("plan").string();
};

TEST_F(ProjectTiles, AnImpactEqualsThatOfOneCommand) {
    ASSERT_EQ(project("add-scenario", {"Before"}).code, 0);
    ASSERT_EQ(project("demolish", {"One57", "432 Park Avenue", "--scenario", "Before"}).code, 0);
    const CommandOutput made = plan({"--scenario", "Existing", "--baseline", "Before"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_GT(made.json()["tiles"], 1);
    runAndMerge(made.json()["tasks"]);
    expectEqualMaps("impact", {"--from", "Before", "--to", "Existing"});
    EXPECT_TRUE(std::filesystem::exists(folder_.path("plan/merged/before.tif")));
}

TEST_F(ProjectTiles, AScoreEqualsThatOfOneCommand) {
    const CommandOutput made = plan({"--weights", "default"});
    ASSERT_EQ(made.code, 0) << made.err;
    runAndMerge(made.json()["tasks"]);
    expectEqualMaps("score", {});
}

TEST_F(ProjectTiles, TimelinesEqualThoseOfOneCommand) {
    ASSERT_EQ(project("add-scenario", {"Before"}).code, 0);
    ASSERT_EQ(project("demolish", {"One57", "432 Park Avenue", "--scenario", "Before"}).code, 0);
    const std::string places = folder_
                                   .file("places.geojson", R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"name": "Sheep Meadow"}, "geometry": {"type": "Polygon", "coordinates":
            [[[-73.979, 40.766], [-73.974, 40.766], [-73.974, 40.772], [-73.979, 40.772], [-73.979, 40.766]]]}}]})")
                                   .string();
    ASSERT_EQ(noonmarkCli({"project", "place", "read", file_, places}).code, 0);
    const CommandOutput made =
        plan({"--scenario", "Existing", "--baseline", "Before", "--timelines", places});
    ASSERT_EQ(made.code, 0) << made.err;
    for (std::size_t task = 0; task < made.json()["tasks"]; ++task)
        ASSERT_EQ(noonmarkCli({"tiles", "run", planned_, "--task", std::to_string(task)}).code, 0);
    const CommandOutput merged = noonmarkCli({"tiles", "merge", planned_});
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_THAT(merged.out, HasSubstr("1 place"));

    std::ifstream file(folder_.path("plan/merged/timelines.jsonl"));
    const auto tiled = nlohmann::json::parse(file);
    const auto alone =
        noonmarkCli({"timeline", file_,      "--place", "Sheep Meadow", "--from", "Before",
                     "--to",     "Existing", "--day",   "2026-12-21",   "--at",   "12:00",
                     "--hours",  "1",        "--step",  "10",           "--zone", "America/New_York",
                     "--cell",   "10",       "--json"})
            .json();
    EXPECT_EQ(tiled["steps"], alone["steps"]);
    EXPECT_EQ(tiled["incremental"], alone["incremental"]);
    EXPECT_GT(tiled["incremental"]["duration_min"], 0);
}

// Two places in different tiles, of which one is crossed by borders, in two scenarios.
TEST_F(ProjectTiles, SunByPlaceIsThatOfOneCommandToTheLastDigit) {
    ASSERT_EQ(project("add-scenario", {"Before"}).code, 0);
    ASSERT_EQ(project("demolish", {"One57", "432 Park Avenue", "--scenario", "Before"}).code, 0);
    const std::string places = folder_
                                   .file("places.geojson", R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"name": "Sheep Meadow"}, "geometry": {"type": "Polygon", "coordinates":
            [[[-73.979, 40.766], [-73.974, 40.766], [-73.974, 40.772], [-73.979, 40.772], [-73.979, 40.766]]]}},
        {"type": "Feature", "properties": {"name": "Pond"}, "geometry": {"type": "Polygon", "coordinates":
            [[[-73.974, 40.764], [-73.9735, 40.764], [-73.9735, 40.7645], [-73.974, 40.7645], [-73.974, 40.764]]]}}]})")
                                   .string();
    ASSERT_EQ(noonmarkCli({"project", "place", "read", file_, places}).code, 0);
    std::vector<std::string> same{"--from", "12:00",    "--scenario", "Existing", "--baseline",
                                  "Before", "--enough", "0.5",        "--date",   "2026-12-22"};
    same.insert(same.end(), noon.begin(), noon.end());
    std::vector<std::string> words{"tiles", "plan",  file_,    "--region", "city", "--by-place",
                                   file_,   "--out", planned_, "--tile",   "64",   "--json"};
    words.insert(words.end(), same.begin(), same.end());
    const CommandOutput made = noonmarkCli(words);
    ASSERT_EQ(made.code, 0) << made.err;
    for (std::size_t task = 0; task < made.json()["tasks"]; ++task)
        ASSERT_EQ(noonmarkCli({"tiles", "run", planned_, "--task", std::to_string(task)}).code, 0);
    const CommandOutput merged =
        noonmarkCli({"tiles", "merge", planned_, "--sheets", "--ramp", "viridis", "--threshold", "0.7"});
    ASSERT_EQ(merged.code, 0) << merged.err;
    EXPECT_THAT(merged.out, HasSubstr("2 places"));

    std::vector<std::string> alone{"by-place", file_, "--out", folder_.path("out").string()};
    alone.insert(alone.end(), same.begin(), same.end());
    const CommandOutput output = noonmarkCli(alone);
    ASSERT_EQ(output.code, 0) << output.err;
    const auto textOf = [&](const char* file) { return readBytes(folder_.path(file)); };
    for (const char* table : {"places.csv", "places_by_time.csv"}) {
        EXPECT_EQ(textOf(("plan/merged/" + std::string(table)).c_str()),
                  textOf(("out/" + std::string(table)).c_str()));
        EXPECT_THAT(textOf(("out/" + std::string(table)).c_str()),
                    testing::AllOf(HasSubstr(",change_hours"), HasSubstr(",Existing,without,")));
    }
    const auto tiled = nlohmann::json::parse(textOf("plan/merged/places.json")),
               whole = nlohmann::json::parse(textOf("out/places.json"));
    EXPECT_EQ(tiled["places"], whole["places"]);
    EXPECT_EQ(tiled["period"], whole["period"]);
    EXPECT_THAT(textOf("plan/merged/places.gpkg"), HasSubstr("to 0.7 h")) << "the threshold of the style";
    EXPECT_THAT(textOf("plan/merged/sheets.pdf"), testing::StartsWith("%PDF"));
}

TEST_F(ProjectTiles, WhatTheProjectLacksIsRefused) {
    EXPECT_THAT(plan({"--weights", "none"}).err, HasSubstr("none"));
    EXPECT_EQ(plan({"--scenario", "C"}).code, 2);
    EXPECT_EQ(plan({"--baseline", "Existing"}).code, 2);  // of which scenario?
    EXPECT_THAT(plan({"--weights", "default", "--by", "month"}).err, HasSubstr("--weights"));
    EXPECT_THAT(plan({"--timelines", "no such file.gpkg"}).err, HasSubstr("no such file.gpkg"));
    EXPECT_EQ(plan({"--timelines", "a.gpkg", "--weights", "default"}).code, 2);
    EXPECT_EQ(plan({"--timelines", "a.gpkg", "--by-place", "a.gpkg"}).code, 2);
    EXPECT_EQ(plan({"--enough", "3"}).code, 2) << "of places only";
    EXPECT_THAT(plan({"--by-place", file_}).err, HasSubstr("no such place"));
    const CommandOutput files = noonmarkCli({"tiles", "plan", "town.gpkg", "--region", "city", "--start",
                                             "2026-12-21", "--weights", "default", "--out", planned_});
    EXPECT_THAT(files.err, HasSubstr("Only a project"));
}

}  // namespace
}  // namespace noonmark::cli::tests
