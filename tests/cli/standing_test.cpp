#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/command_output.h"
#include "tests/core/io/footprint_files.h"
#include "tests/core/io/terrain_files.h"

namespace noonmark::cli::tests {
namespace {

using noonmark::tests::feature;
using noonmark::tests::manhattan;
using noonmark::tests::sizedRectangle;
using testing::HasSubstr;

// Three towers whose stated ground lies 20 m above a level terrain.
class StandingCommand : public testing::Test {
protected:
    CommandOutput say(std::vector<std::string> arguments, const std::vector<std::string>& more = {}) {
        arguments.insert(arguments.end(), {town.string(), terrain.string()});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    }
    double shadowArea(const std::vector<std::string>& more) {
        std::vector<std::string> all{"--start",     "2026-03-21",
                                     "--from",      "09:00",
                                     "--hours",     "6",
                                     "--step",      "15",
                                     "--zone",      "America/New_York",
                                     "--region",    "-73.9815,40.7495,-73.9785,40.7515",
                                     "--cell",      "2",
                                     "--out",       folder.path("out").string(),
                                     "--overwrite", "--json"};
        all.insert(all.end(), more.begin(), more.end());
        const CommandOutput output = say({"study"}, all);
        EXPECT_EQ(output.code, exitOk) << output.err;
        last = output.json();
        return last["shadow_area_m2"];
    }

    noonmark::tests::TemporaryFolder folder;
    std::filesystem::path town = folder.file(
        "town.geojson",
        R"({"type":"FeatureCollection","features":[)" +
            feature(sizedRectangle(-60, 0, 20, 20), R"("height":30,"ground_elevation":70)") + "," +
            feature(sizedRectangle(0, 0, 20, 20), R"("height":30,"ground_elevation":70)") + "," +
            feature(sizedRectangle(60, 0, 20, 20), R"("height":30,"ground_elevation":70)") + "]}");
    std::filesystem::path terrain =
        noonmark::tests::writeTerrain(folder.path("level.tif"), manhattan, [](double, double) { return 50; });
    nlohmann::json last;
};

TEST_F(StandingCommand, InfoStatesTheGapAndWhatWasDone) {
    EXPECT_THAT(
        say({"info"}).out,
        HasSubstr("Bases of town.geojson lie 20 m above the terrain (median of 3, spread 0 m); all were "
                  "shifted onto it"));
    const nlohmann::json info = say({"info"}, {"--json"}).json();
    EXPECT_EQ(info["heights"]["bases"][0]["rule"], "shifted");
    EXPECT_NEAR(info["heights"]["bases"][0]["gap_m"].get<double>(), 20, 0.01);
    EXPECT_EQ(say({"info"}, {"--stand", "hover"}).code, exitUsage);
}

// Of towers of 30 m, not of 50 m as their stated elevations have it.
TEST_F(StandingCommand, AStudyIsThatOfTheTownOnTheTerrainUnlessTheUserWantsElevations) {
    const double automatic = shadowArea({});
    EXPECT_FALSE(last["read_settings"].contains("stand"));
    EXPECT_EQ(last["heights"]["bases"][0]["rule"], "shifted");
    EXPECT_NEAR(shadowArea({"--stand", "terrain"}), automatic, 0.5);
    const double absolute = shadowArea({"--stand", "absolute"});
    EXPECT_GT(absolute, automatic * 1.2);
    EXPECT_THAT(last["repeat"].get<std::string>(), HasSubstr("--stand absolute"));
    EXPECT_TRUE(last["read_settings"].contains("stand"));
}

TEST_F(StandingCommand, ImportKeepsTheFigure) {
    const double before = shadowArea({});
    ASSERT_EQ(say({"import"}, {"--out", folder.path("city.gpkg").string()}).code, exitOk);
    town = folder.path("city.gpkg");
    EXPECT_NEAR(shadowArea({}), before, before * 1e-3);
}

}  // namespace
}  // namespace noonmark::cli::tests
