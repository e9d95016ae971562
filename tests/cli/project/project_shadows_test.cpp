#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {
namespace {

using testing::HasSubstr;

/// A project with a scenario in which a tower is gone: the existing city is the proposal.
class ProjectShadows : public ProjectCommand {
protected:
    void SetUp() override {
        ProjectCommand::SetUp();
        done("add-scenario", {"Before"});
        done("demolish", {"One57", "--scenario", "Before"});
    }

    CommandOutput shadows(std::vector<std::string> more) {
        std::vector<std::string> arguments{"project", "shadows",    file_,    "--from",          "Before",
                                           "--day",   "2026-03-21", "--zone", "America/New_York"};
        arguments.insert(arguments.end(), {"--out", folder_.path("out").string()});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    }

    std::vector<std::string> written() {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path("out")))
            names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }
};

TEST_F(ProjectShadows, WritesTheFormatsThatWereAskedFor) {
    const CommandOutput output =
        shadows({"--to", "Existing", "--times", "12:00,10:30", "--format", "dxf,gpkg,geojson,svg", "--json"});
    ASSERT_EQ(output.code, 0) << output.err;
    const auto moments = output.json()["moments"];
    ASSERT_EQ(moments.size(), 2U);
    EXPECT_EQ(moments[0]["name"], "2026-03-21_1030");
    EXPECT_EQ(moments[1]["time"], "2026-03-21 12:00 America/New_York");
    EXPECT_GT(moments[1]["incremental_m2"], 100);
    EXPECT_EQ(moments[1]["gained_m2"], 0);
    EXPECT_EQ(moments[1]["cell_m"], 0);
    EXPECT_THAT(written(), testing::ElementsAre(
                               "buildings.geojson", "fan.geojson", "shadows.dxf", "shadows.geojson",
                               "shadows.gpkg", "shadows_2026-03-21_1030.svg", "shadows_2026-03-21_1200.svg"));
}

TEST_F(ProjectShadows, ReplacesFilesOnlyWhenAsked) {
    ASSERT_EQ(shadows({"--to", "Existing", "--times", "12:00"}).code, 0);
    const CommandOutput again = shadows({"--to", "Existing", "--times", "12:00"});
    EXPECT_NE(again.code, 0);
    EXPECT_THAT(again.err, HasSubstr("--overwrite"));
    EXPECT_EQ(shadows({"--to", "Existing", "--times", "12:00", "--overwrite"}).code, 0);
}

TEST_F(ProjectShadows, ARegionAndAnInterval) {
    const CommandOutput output =
        shadows({"--region", "Park", "--every", "180", "--format", "gpkg", "--json"});
    ASSERT_EQ(output.code, 0) << output.err;
    const auto moments = output.json()["moments"];
    ASSERT_EQ(moments.size(), 4U);  // 09:00, 12:00, 15:00 and 18:00; the sun sets at 19:10
    EXPECT_EQ(moments[3]["name"], "2026-03-21_1800");
    EXPECT_EQ(moments[3]["incremental_m2"], 0);
    EXPECT_THAT(written(), testing::ElementsAre("shadows.gpkg"));
}

TEST_F(ProjectShadows, StatesWhatIsWrong) {
    EXPECT_THAT(shadows({}).err, HasSubstr("--times"));
    EXPECT_THAT(shadows({"--times", "25:00"}).err, HasSubstr("25:00"));
    EXPECT_THAT(shadows({"--times", "23:00"}).err, HasSubstr("below the horizon"));
    EXPECT_THAT(shadows({"--times", "12:00,23:00", "--to", "Existing", "--overwrite"}).out,
                HasSubstr("below the horizon"));
    EXPECT_NE(shadows({"--times", "12:00", "--format", "dwg"}).code, 0);
    EXPECT_NE(shadows({"--times", "12:00", "--place", "Nowhere Park"}).code, 0);
    EXPECT_NE(shadows({"--times", "12:00", "--to", "Nothing"}).code, 0);
}

}  // namespace
}  // namespace noonmark::cli::tests
