#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/cli/command_output.h"
#include "tests/core/io/footprint_files.h"

namespace noonmark::cli::tests {
namespace {

using noonmark::tests::feature;
using noonmark::tests::sizedRectangle;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A tower and two trees of an inventory in inches, north of it.
class TreesCommand : public testing::Test {
protected:
    CommandOutput study(const std::vector<std::string>& more) {
        std::vector<std::string> all{"study",      town.string(),
                                     "--start",    "2026-01-15",
                                     "--from",     "09:00",
                                     "--hours",    "6",
                                     "--step",     "10",
                                     "--zone",     "America/New_York",
                                     "--region",   "-73.9815,40.7495,-73.9785,40.7515",
                                     "--cell",     "2",
                                     "--out",      folder.path("out").string(),
                                     "--overwrite"};
        all.insert(all.end(), more.begin(), more.end());
        return noonmarkCli(all);
    }
    nlohmann::json figures(std::vector<std::string> more) {
        more.emplace_back("--json");
        const CommandOutput output = study(more);
        EXPECT_EQ(output.code, exitOk) << output.err;
        return output.json();
    }

    noonmark::tests::TemporaryFolder folder;
    std::filesystem::path town =
        folder.file("town.geojson", R"({"type":"FeatureCollection","features":[)" +
                                        feature(sizedRectangle(0, 0, 20, 20), R"("height":30)") + "]}");
    std::string inventory = folder
                                .file("trees.csv",
                                      "tree_dbh,spc_latin,latitude,longitude\n"
                                      "20,Platanus x acerifolia,40.7505,-73.9803\n"
                                      "10,Pinus nigra,40.7506,-73.9797\n")
                                .string();
};

TEST_F(TreesCommand, InfoCountsThemBySource) {
    const nlohmann::json info = noonmarkCli({"info", town.string(), "--trees", inventory, "--json"}).json();
    EXPECT_EQ(info["trees"]["count"], 2);
    EXPECT_EQ(info["trees"]["evergreen"], 1);
    EXPECT_EQ(info["trees"]["height_sources"]["estimated"], 2);
    EXPECT_TRUE(noonmarkCli({"info", town.string(), "--json"}).json()["trees"].is_null());
    EXPECT_NE(noonmarkCli({"info", town.string(), "--trees", "nowhere.csv"}).code, exitOk);
}

TEST_F(TreesCommand, AStudyHasThreeColumns) {
    const nlohmann::json bare = figures({}), all = figures({"--trees", inventory});
    EXPECT_FALSE(bare.contains("mean_gross_min_evergreen"));
    EXPECT_EQ(all["mean_gross_min"], bare["mean_gross_min"]);
    const double evergreen = all["mean_gross_min_evergreen"], seasonal = all["mean_gross_min_seasonal"];
    EXPECT_GT(seasonal, all["mean_gross_min"].get<double>());
    EXPECT_GT(evergreen, seasonal);
    EXPECT_EQ(all["trees"]["used"], 2);
    EXPECT_NEAR(all["trees"]["share_of_shade_evergreen"].get<double>(),
                1 - bare["mean_gross_min"].get<double>() / evergreen, 1e-9);
    EXPECT_TRUE(all["definitions"].contains("shadow_area_m2_seasonal"));
    EXPECT_THAT(all["repeat"].get<std::string>(), HasSubstr("--trees"));
}

TEST_F(TreesCommand, TheColumnsAreChosen) {
    const nlohmann::json without = figures({"--trees", inventory, "--tree-shade", "without"});
    EXPECT_FALSE(without.contains("mean_gross_min_evergreen"));
    const nlohmann::json seasonal = figures({"--trees", inventory, "--tree-shade", "seasonal"});
    EXPECT_FALSE(seasonal.contains("mean_gross_min_evergreen"));
    EXPECT_TRUE(seasonal.contains("mean_gross_min_seasonal"));
    EXPECT_THAT(seasonal["repeat"].get<std::string>(), HasSubstr("--tree-shade seasonal"));
    EXPECT_EQ(study({"--tree-shade", "sometimes"}).code, exitUsage);
}

TEST_F(TreesCommand, TheTableAndTheCellsStateThem) {
    EXPECT_THAT(study({"--trees", inventory, "--cells-csv"}).out, HasSubstr("trees with their seasons"));
    std::ifstream cells(folder.path("out") / "cells.csv");
    std::string heading;
    std::getline(cells, heading);
    EXPECT_THAT(heading, HasSubstr("gross_min_evergreen,continuous_min_evergreen,gross_min_seasonal"));
    EXPECT_THAT(study({}).out, Not(HasSubstr("trees")));
}

// January has all days of the period: its figures are those of the period.
TEST_F(TreesCommand, MonthsHaveThreeColumns) {
    const nlohmann::json all = figures({"--trees", inventory, "--by", "month"});
    const nlohmann::json& month = all.at("by_month").at(0);
    for (const char* key : {"shadow_area_m2", "shadow_area_m2_evergreen", "shadow_area_m2_seasonal"})
        EXPECT_NEAR(month.at(key).get<double>(), all.at(key).get<double>(), 1e-3 * all.at(key).get<double>())
            << key;
    EXPECT_LT(month.at("mean_shadow_min"), month.at("mean_shadow_min_seasonal"));
    std::ifstream table(folder.path("out") / "by_month.csv");
    std::string heading;
    std::getline(table, heading);
    EXPECT_THAT(heading, HasSubstr("mean_shadow_min,shadow_area_m2_evergreen,mean_shadow_min_evergreen,"));
    EXPECT_FALSE(figures({"--by", "month"}).at("by_month").at(0).contains("shadow_area_m2_evergreen"));
}

// A question about the town with its two trees; `says`: why they are left out.
class TreesLeftOut : public TreesCommand {
protected:
    void expectSaid(std::vector<std::string> question, const std::string& says) {
        for (const char* word : {"--trees", inventory.c_str(), "--json"}) question.emplace_back(word);
        const CommandOutput output = noonmarkCli(question);
        ASSERT_EQ(output.code, exitOk) << output.err;
        const nlohmann::json warnings = output.json().at("warnings");
        const auto isAboutTrees = [&](const nlohmann::json& warning) {
            return warning.at("what") == "trees: " + says;
        };
        const auto found = std::ranges::find_if(warnings, isAboutTrees);
        ASSERT_NE(found, warnings.end()) << question.front() << ": " << warnings;
        EXPECT_EQ(found->at("kind"), "left out");
        EXPECT_EQ(found->at("where"), nlohmann::json{"2 trees"});
    }
    std::vector<std::string> over(std::vector<std::string> question) const {
        for (const char* word : {"--start", "2026-01-15", "--zone", "America/New_York", "--step", "30",
                                 "--cell", "4", "--out", "--overwrite"}) {
            question.emplace_back(word);
            if (question.back() == "--out") question.push_back(folder.path(question.front()).string());
        }
        return question;
    }

    const std::string region = "-73.9815,40.7495,-73.9785,40.7515";
};

TEST_F(TreesLeftOut, APointLeavesNoneOut) {
    const CommandOutput output =
        noonmarkCli({"point", town.string(), "--at", "-73.9800,40.7504", "--trees", inventory, "--json"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    for (const nlohmann::json& warning : output.json().at("warnings"))
        EXPECT_THAT(warning.at("what").get<std::string>(), testing::Not(HasSubstr("trees: "))) << warning;
}

TEST_F(TreesLeftOut, StudiesInTilesCountThem) {
    auto question =
        over({"city-study", town.string(), "--trees", inventory, "--region", region, "--by", "month"});
    const CommandOutput printed = noonmarkCli(question);
    ASSERT_EQ(printed.code, exitOk) << printed.err;
    EXPECT_THAT(printed.out, AllOf(HasSubstr("trees with their seasons"), HasSubstr("2 can reach a receiver"),
                                   HasSubstr("shadow_evergreen.tif"), HasSubstr("by_month_seasonal.tif")));
    for (const char* file : {"shadow_seasonal.tif", "shadow_seasonal.qml", "by_month_evergreen.tif"})
        EXPECT_TRUE(std::filesystem::exists(folder.path("city-study") / file)) << file;
    question.emplace_back("--json");
    const nlohmann::json json = noonmarkCli(question).json();
    EXPECT_EQ(json.at("trees").at("used"), 2);
    EXPECT_GT(json.at("mean_gross_min_seasonal").get<double>(), json.at("mean_gross_min").get<double>());
    EXPECT_TRUE(json.at("by_month").at(0).contains("shadow_area_m2_evergreen"));
    question.insert(question.end(), {"--tree-shade", "without"});
    const nlohmann::json without = noonmarkCli(question).json();
    EXPECT_FALSE(without.contains("mean_gross_min_seasonal"));
    EXPECT_EQ(without.at("mean_gross_min"), json.at("mean_gross_min"));
}

// A tree before the southern facade of the building, whose corner is at 40.75 N 73.98 W.
TEST_F(TreesLeftOut, FacadesCountThem) {
    const std::string before = folder
                                   .file("south.csv",
                                         "tree_dbh,spc_latin,latitude,longitude\n"
                                         "20,Platanus x acerifolia,40.74985,-73.9799\n")
                                   .string();
    auto question = over({"study", town.string(), "--trees", before, "--region", region});
    for (const char* word : {"--receivers", "facades"}) question.emplace_back(word);
    EXPECT_THAT(noonmarkCli(question).out, HasSubstr("trees with their seasons"));
    question.emplace_back("--json");
    const nlohmann::json facades = noonmarkCli(question).json();
    EXPECT_LT(facades.at("mean_sunlit_min_evergreen"), facades.at("mean_sunlit_min"));
    for (const nlohmann::json& warning : facades.at("warnings"))
        EXPECT_THAT(warning.at("what").get<std::string>(), Not(testing::StartsWith("trees:")));
}

TEST_F(TreesLeftOut, SunByPlaceCountsThem) {
    auto question = over({"by-place", town.string(), "--trees", inventory, "--region", region});
    for (const char* word : {"--kind", "park", "--date", "2026-07-01", "--json"}) question.emplace_back(word);
    const nlohmann::json all = noonmarkCli(question).json();
    const nlohmann::json& place = all.at("places").at(0);
    EXPECT_LT(place.at("hours_mean_evergreen"), place.at("hours_mean_seasonal"));
    EXPECT_LT(place.at("hours_mean_seasonal"), place.at("hours_mean"));
    EXPECT_NEAR(place.at("month_hours_evergreen").at("2026-01").get<double>(),
                place.at("hours_mean_evergreen").get<double>(), 2e-4);
    EXPECT_EQ(place.at("date_hours_evergreen"), place.at("date_hours_seasonal")) << "in leaf in July";
    EXPECT_TRUE(all.at("definitions").contains("share_enough_seasonal"));
    for (const nlohmann::json& warning : all.at("warnings"))
        EXPECT_THAT(warning.at("what").get<std::string>(), Not(testing::StartsWith("trees:")));
    std::ifstream table(folder.path("by-place") / "places_by_time.csv");
    const std::string rows{std::istreambuf_iterator<char>(table), {}};
    EXPECT_THAT(rows, HasSubstr(",evergreen,2026-01,month,"));
    question.insert(question.end(), {"--tree-shade", "seasonal"});
    const nlohmann::json seasonal = noonmarkCli(question).json();
    EXPECT_FALSE(seasonal.at("places").at(0).contains("hours_mean_evergreen"));
    EXPECT_THAT(seasonal.at("repeat").get<std::string>(), HasSubstr("--tree-shade seasonal"));
}

TEST_F(TreesLeftOut, MapsByPlaceAreOfTheColumnThatIsChosen) {
    auto question = over({"by-place", town.string(), "--trees", inventory, "--region", region});
    for (const char* word : {"--kind", "park", "--map-trees", "seasonal"}) question.emplace_back(word);
    const CommandOutput output = noonmarkCli(question);
    ASSERT_EQ(output.code, exitOk) << output.err;
    const auto read = [&](const char* name) {
        std::ifstream file(folder.path("by-place") / name, std::ios::binary);
        return std::string{std::istreambuf_iterator<char>(file), {}};
    };
    // GeoTIFF holds the names of bands as XML, counted from 0; QGIS counts from 1.
    const std::string raster = read("sun_by_place.tif"), style = read("sun_by_place.qml");
    const std::size_t at = style.find("band=\"") + 6;
    const int band = std::stoi(style.substr(at));
    const std::size_t item = raster.find("sample=\"" + std::to_string(band - 1) + "\" role=\"description\"");
    ASSERT_NE(item, std::string::npos) << band;
    EXPECT_THAT(raster.substr(item, raster.find('<', item) - item), HasSubstr("trees with their seasons"));
    EXPECT_THAT(raster, HasSubstr("trees as evergreens"));
}

TEST_F(TreesLeftOut, FilesWithoutThemSaySo) {
    expectSaid({"import", town.string(), "--out", folder.path("city.gpkg").string()},
               "a GeoPackage of buildings does not hold them");
}

TEST_F(TreesLeftOut, ACopyOfTheInventoryIsNotOverwritten) {
    const CommandOutput written =
        noonmarkCli({"import", town.string(), "--trees", inventory, "--out", inventory, "--overwrite"});
    EXPECT_NE(written.code, exitOk);
    std::ifstream file(inventory);
    std::string heading;
    std::getline(file, heading);
    EXPECT_EQ(heading, "tree_dbh,spc_latin,latitude,longitude");
}

TEST_F(TreesLeftOut, AStudyCountsThem) {
    EXPECT_THAT(study({"--trees", inventory}).out, Not(HasSubstr("left out: trees")));
    for (const nlohmann::json& warning : figures({"--trees", inventory}).at("warnings"))
        EXPECT_THAT(warning.at("what").get<std::string>(), Not(testing::StartsWith("trees:")));
}

// The town with its two trees as a project, with a scenario.
class TreesOfAProject : public TreesCommand {
protected:
    void SetUp() override {
        ASSERT_EQ(noonmarkCli({"project", "new", project, town.string(), "--trees", inventory}).code, exitOk);
        ASSERT_EQ(noonmarkCli({"project", "add-scenario", project, "Avenue"}).code, exitOk);
    }
    // A question about six hours of a day in January of the project.
    CommandOutput inJanuary(const std::string& command, const std::vector<std::string>& more) {
        std::vector<std::string> all{command,      project,
                                     "--region",   "-73.9815,40.7495,-73.9785,40.7515",
                                     "--start",    "2026-01-15",
                                     "--at",       "09:00",
                                     "--hours",    "6",
                                     "--step",     "10",
                                     "--zone",     "America/New_York",
                                     "--cell",     "4",
                                     "--out",      folder.path(command).string(),
                                     "--overwrite"};
        all.insert(all.end(), more.begin(), more.end());
        return noonmarkCli(all);
    }
    CommandOutput tree(std::vector<std::string> words) {
        words.insert(words.begin() + 1, project);
        words.insert(words.begin(), {"project", "tree"});
        return noonmarkCli(words);
    }
    nlohmann::json list() { return tree({"list", "--json"}).json(); }
    nlohmann::json impact(std::vector<std::string> more = {}) {
        std::vector<std::string> all{"impact",   project,
                                     "--to",     "Avenue",
                                     "--region", "-73.9815,40.7495,-73.9785,40.7515",
                                     "--start",  "2026-01-15",
                                     "--from",   "Existing",
                                     "--hours",  "6",
                                     "--at",     "09:00",
                                     "--step",   "10",
                                     "--zone",   "America/New_York",
                                     "--cell",   "2",
                                     "--out",    folder.path("out").string(),
                                     "--json",   "--overwrite"};
        all.insert(all.end(), more.begin(), more.end());
        const CommandOutput output = noonmarkCli(all);
        EXPECT_EQ(output.code, exitOk) << output.err;
        return output.json();
    }

    const std::string project = folder.path("town.noonmark.gpkg").string();
};

TEST_F(TreesOfAProject, AreStoredWithTheirFilesHash) {
    const nlohmann::json trees = list();
    ASSERT_EQ(trees.size(), 2U);
    EXPECT_EQ(trees[0]["species"], "Platanus x acerifolia");
    EXPECT_NEAR(trees[0]["crown_diameter_m"].get<double>(), 25.5 * 20 * 0.0254, 1e-4);
    EXPECT_EQ(trees[1]["evergreen"], true);
    const nlohmann::json inputs = impact().at("inputs");
    const auto isInventory = [&](const nlohmann::json& input) { return input.at("path") == inventory; };
    const auto found = std::ranges::find_if(inputs, isInventory);
    ASSERT_NE(found, inputs.end()) << inputs;
    EXPECT_EQ(found->at("sha256").get<std::string>().size(), 64U);
}

TEST_F(TreesOfAProject, FellingThemChangesTheShadowWithTreesOnly) {
    ASSERT_EQ(tree({"remove", "--within", "-73.9815,40.7495,-73.9785,40.7515", "--scenario", "Avenue"}).code,
              exitOk);
    const nlohmann::json change = impact().at("impact").at(0);
    EXPECT_EQ(change.at("gross").at("mean_min"), 0);
    EXPECT_LT(change.at("gross_evergreen").at("mean_min"), 0);
    EXPECT_LT(change.at("gross_seasonal").at("mean_min"), 0);
    EXPECT_FALSE(impact({"--tree-shade", "seasonal"}).at("impact").at(0).contains("gross_evergreen"));
}

TEST_F(TreesOfAProject, WhatLeavesThemOutSaysSo) {
    const CommandOutput drawn =
        noonmarkCli({"project", "shadows", project, "--day", "2026-01-15", "--times", "12:00", "--region",
                     "-73.9815,40.7495,-73.9785,40.7515", "--zone", "America/New_York", "--out",
                     folder.path("drawn").string()});
    EXPECT_THAT(drawn.out, HasSubstr("trees:")) << drawn.err;
}

TEST_F(TreesOfAProject, APointSeesThem) {
    const CommandOutput point = noonmarkCli(
        {"point", project, "--at", "-73.9800,40.7504", "--json", "--svg", folder.path("sky.svg").string()});
    ASSERT_EQ(point.code, exitOk) << point.err;
    for (const nlohmann::json& warning : point.json().at("warnings"))
        EXPECT_THAT(warning.at("what").get<std::string>(), Not(testing::StartsWith("trees:")));
    EXPECT_GT(point.json().at("trees").at("crowns").size(), 0U);
    std::ifstream svg(folder.path("sky.svg"));
    const std::string drawing{std::istreambuf_iterator<char>(svg), {}};
    EXPECT_THAT(drawing, HasSubstr("fill-opacity"));
    EXPECT_THAT(drawing, HasSubstr("trees, as dense as on the day"));
}

// Of a wall, so that it has a vertical sky component.
TEST_F(TreesOfAProject, APointStatesTheSkyThatTreesLeave) {
    const std::vector<std::string> wall{"point", project, "--at", "-73.9800,40.7504,2", "--facing", "0"};
    auto asked = wall;
    asked.insert(asked.end(), {"--all-scenarios", "--json"});
    const CommandOutput point = noonmarkCli(asked);
    ASSERT_EQ(point.code, exitOk) << point.err;
    const nlohmann::json json = point.json();
    std::vector<nlohmann::json> all{json};
    for (const nlohmann::json& one : json.at("scenarios")) all.push_back(one);
    ASSERT_EQ(all.size(), 3U) << "the point, the existing city and the scenario";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const nlohmann::json& of = all[i];
        for (const std::string key : {"svf", "vsc_pct"}) {
            EXPECT_GE(of.at(key + "_evergreen"), 0) << i << key;
            EXPECT_LE(of.at(key + "_evergreen"), of.at(key + "_seasonal")) << i << key;
            EXPECT_LE(of.at(key + "_seasonal"), of.at(key)) << i << key;
        }
        EXPECT_LT(of.at("svf_evergreen"), of.at("svf")) << i;
    }
    EXPECT_EQ(json.at("svf_seasonal"), json.at("scenarios").at(0).at("svf_seasonal"));
    EXPECT_GT(json.at("taken_by_tree").size(), 0U);
    EXPECT_THAT(noonmarkCli(wall).out,
                AllOf(HasSubstr("sky with trees"), HasSubstr("as evergreens; vertical sky")));
}

TEST_F(TreesCommand, ContributionsRankTreesWithBuildings) {
    const CommandOutput output = study({"--trees", inventory, "--contributions"});
    ASSERT_EQ(output.code, exitOk) << output.err;
    EXPECT_THAT(output.out, AllOf(HasSubstr("shaded by"), HasSubstr("tree Pinus nigra ("),
                                  HasSubstr("(trees with their seasons)")));
    const CommandOutput bare = study({"--contributions"});
    EXPECT_THAT(bare.out, AllOf(HasSubstr("shaded by"), Not(HasSubstr("tree "))));
}

TEST_F(TreesOfAProject, AScoreHasThreeColumns) {
    const auto with = [&](const std::vector<std::string>& more) { return inJanuary("score", more); };
    const nlohmann::json score = with({"--json"}).json();
    // January weighs -1: more shadow scores less.
    EXPECT_LT(score.at("score_m2_evergreen"), score.at("score_m2_seasonal"));
    EXPECT_LT(score.at("score_m2_seasonal"), score.at("score_m2"));
    for (const nlohmann::json& warning : score.at("warnings"))
        EXPECT_THAT(warning.at("what").get<std::string>(), Not(testing::StartsWith("trees:")));
    EXPECT_THAT(with({}).out, HasSubstr("trees as evergreens"));
    EXPECT_FALSE(with({"--json", "--tree-shade", "without"}).json().contains("score_m2_evergreen"));
}

TEST_F(TreesOfAProject, ScenariosHaveThreeColumns) {
    ASSERT_EQ(tree({"remove", "--within", "-73.9815,40.7495,-73.9785,40.7515", "--scenario", "Avenue"}).code,
              exitOk);
    const nlohmann::json all = inJanuary("scenarios", {"--weights", "default", "--json"}).json();
    const nlohmann::json& existing = all.at("scenarios").at(0).at("figures");
    const nlohmann::json& felled = all.at("scenarios").at(1).at("figures");
    EXPECT_EQ(existing.at("shadow_area_m2"), felled.at("shadow_area_m2"));
    EXPECT_GT(existing.at("shadow_area_m2_evergreen"), existing.at("shadow_area_m2_seasonal"));
    EXPECT_FALSE(felled.contains("shadow_area_m2_evergreen")) << "no tree is left";
    EXPECT_LT(all.at("scenarios").at(0).at("score").at("score_m2_seasonal"),
              all.at("scenarios").at(0).at("score").at("score_m2"));
    EXPECT_TRUE(all.at("definitions").contains("shadow_area_m2_seasonal"));
    std::ifstream table(folder.path("scenarios") / "scenarios.csv");
    std::string heading;
    std::getline(table, heading);
    EXPECT_THAT(heading, HasSubstr(",shadow_area_m2_evergreen,"));
    EXPECT_THAT(heading, HasSubstr(",score_m2_seasonal,"));
}

TEST_F(TreesOfAProject, ARowIsPlantedMovedAndGrown) {
    const CommandOutput row =
        tree({"add", "--along", "-73.9805,40.7500", "-73.9795,40.7500", "--spacing", "10", "--species",
              "Tilia cordata", "--height", "8", "--scenario", "Avenue"});
    ASSERT_EQ(row.code, exitOk) << row.err;
    // 0.001 degrees of longitude are 84.4 m here: trees at 0, 10, ..., 80 m.
    EXPECT_EQ(std::ranges::count(row.out, '\n'), 9) << row.out;
    EXPECT_THAT(tree({"grow", "planted 1", "--years", "10", "--scenario", "Avenue"}).out,
                HasSubstr("Grow planted 1 by 10 years to 11.0 m"));
    EXPECT_THAT(tree({"move", "planted 2", "--east", "3", "--scenario", "Avenue"}).out,
                HasSubstr("Move planted 2 by 3.0 m east"));
    EXPECT_GT(impact().at("impact").at(0).at("gross_evergreen").at("mean_min"), 0);
    EXPECT_NE(tree({"remove", "oak", "--scenario", "Avenue"}).code, exitOk);
    EXPECT_NE(tree({"remove", "planted 1", "--scenario", "Existing"}).code, exitOk);
    EXPECT_EQ(list().size(), 2U) << "the existing city stays";
}

TEST_F(TreesOfAProject, InventoriesAreAddedOnce) {
    EXPECT_THAT(tree({"import", inventory}).out, HasSubstr("0 trees read"));
    const std::string more =
        folder.file("more.csv", "height,latitude,longitude\n9,40.7503,-73.9801\n").string();
    EXPECT_THAT(tree({"import", more}).out, HasSubstr("1 tree read; the project has 3"));
}

TEST_F(TreesOfAProject, ATreeThatIsChosenTwiceIsChangedOnce) {
    const std::string id = list().at(0).at("name");
    const CommandOutput moved = tree({"move", id, id, "--within", "-73.9815,40.7495,-73.9785,40.7515",
                                      "--east", "3", "--scenario", "Avenue"});
    ASSERT_EQ(moved.code, exitOk) << moved.err;
    EXPECT_EQ(std::ranges::count(moved.out, '\n'), 2) << moved.out;
}

TEST_F(TreesOfAProject, ACrownBaseAboveTheTopIsRefused) {
    EXPECT_THAT(
        tree({"add", "--at", "-73.98,40.75", "--height", "10", "--crown-base", "12", "--scenario", "Avenue"})
            .err,
        HasSubstr("crown's base"));
}

TEST_F(TreesOfAProject, ATreeHasLeavesAndLeafDaysOfItsOwn) {
    const CommandOutput added = tree({"add", "--at", "-73.98,40.75", "--species", "Acer", "--leaf-on",
                                      "05-10", "--leaf-off", "10-01", "--scenario", "Avenue"});
    EXPECT_EQ(added.code, exitOk) << added.err;
    EXPECT_EQ(tree({"add", "--at", "-73.98,40.751", "--leaves", "evergreen", "--scenario", "Avenue"}).code,
              exitOk);
    EXPECT_NE(tree({"add", "--at", "-73.98,40.752", "--leaves", "some", "--scenario", "Avenue"}).code,
              exitOk);
    EXPECT_THAT(tree({"add", "--at", "-73.98,40.752", "--leaf-on", "02-30", "--scenario", "Avenue"}).err,
                HasSubstr("no day of the year"));
}

TEST_F(TreesOfAProject, LeafDaysAreStated) {
    EXPECT_THAT(tree({"leaves", "--leaf-on", "01-02", "--leaf-off", "12-20"}).out,
                HasSubstr("from 01-02 up to and without 12-20"));
    ASSERT_EQ(tree({"remove", "--within", "-73.9815,40.7495,-73.9785,40.7515", "--scenario", "Avenue"}).code,
              exitOk);
    const nlohmann::json change = impact().at("impact").at(0);  // of January, now in leaf
    EXPECT_EQ(change.at("gross_evergreen"), change.at("gross_seasonal"));
    EXPECT_NE(tree({"leaves", "--leaf-on", "13-01"}).code, exitOk);
}

}  // namespace
}  // namespace noonmark::cli::tests
