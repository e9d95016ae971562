#include <QImageReader>
#include <nlohmann/json.hpp>

#include "scenarios/scenario.h"
#include "tests/cli/project_command.h"
#include "tests/core/engines/scenes.h"

namespace noonmark::cli::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ScenariosCommand : public ProjectCommand {
protected:
    void SetUp() override {
        ProjectCommand::SetUp();
        done("add-scenario", {"Lower"});
        done("height", {"One57", "432 Park Avenue", "--scenario", "Lower", "--height", "30"});
    }
    std::vector<std::string> namesIn(const nlohmann::json& json) {
        std::vector<std::string> names;
        for (const auto& scenario : json.at("scenarios")) names.push_back(scenario.at("name"));
        return names;
    }
};

TEST_F(ScenariosCommand, MeasuresAllScenariosOfAProject) {
    const CommandOutput all = atNoon("scenarios", {"--json"});
    ASSERT_EQ(all.code, 0) << all.err;
    const auto json = all.json();
    const auto names = namesIn(json);
    EXPECT_EQ(names.front(), existingCity);
    EXPECT_THAT(names, testing::Contains("Lower"));
    EXPECT_TRUE(json.at("scenarios")[0].at("warnings").is_array());
    for (const char* file : {"scenarios.csv", "scenarios.json", "scenarios.pdf", "scenarios.tif"})
        EXPECT_GT(std::filesystem::file_size(folder_.path("out") / file), 100U) << file;
    EXPECT_TRUE(std::filesystem::exists(folder_.path("out") / "scenario_uses.csv"));
}

TEST_F(ScenariosCommand, AgreesWithTheStudyOfEachScenario) {
    const CommandOutput two =
        atNoon("scenarios", {"--scenario", "Lower", "--scenario", "Existing", "--json"});
    ASSERT_EQ(two.code, 0) << two.err;
    const auto json = two.json();
    EXPECT_THAT(namesIn(json), ElementsAre("Lower", "Existing"));
    const CommandOutput study = noonmarkCli({"study",      file_,
                                             "--scenario", "Lower",
                                             "--region",   "Park",
                                             "--cell",     "10",
                                             "--start",    "2026-12-21",
                                             "--from",     "12:00",
                                             "--hours",    "1",
                                             "--step",     "10",
                                             "--zone",     "America/New_York",
                                             "--out",      folder_.path("alone").string(),
                                             "--json"});
    ASSERT_EQ(study.code, 0) << study.err;
    EXPECT_EQ(json.at("scenarios")[0]["figures"]["shadow_area_m2"], study.json()["shadow_area_m2"]);
    EXPECT_LT(json.at("scenarios")[0]["figures"]["shadow_area_m2"],
              json.at("scenarios")[1]["figures"]["shadow_area_m2"]);
}

TEST_F(ScenariosCommand, MonthsAndScoresAreThoseOfStudyAndScoreSideBySide) {
    const CommandOutput all =
        atNoon("scenarios", {"--scenario", "Existing", "--scenario", "Lower", "--by", "month", "--weights",
                             "default", "--engine", "horizon", "--json"});
    ASSERT_EQ(all.code, 0) << all.err;
    const auto json = all.json();
    const auto &existing = json["scenarios"][0]["months"][0], &lower = json["scenarios"][1]["months"][0];
    EXPECT_EQ(lower["month"], "2026-12");
    EXPECT_GT(lower["sun_change_hours"], 0) << "lower towers leave more sun";
    EXPECT_DOUBLE_EQ(lower["sun_change_hours"],
                     lower["sun_hours"].get<double>() - existing["sun_hours"].get<double>());
    EXPECT_TRUE(existing["sun_change_hours"].is_null());
    const CommandOutput score = atNoon("score", {"--scenario", "Lower", "--weights", "default", "--engine",
                                                 "horizon", "--overwrite", "--json"});
    ASSERT_EQ(score.code, 0) << score.err;
    EXPECT_EQ(lower["score_m2"], score.json()["months"][0]["score_m2"]);
    EXPECT_EQ(json["scenarios"][1]["score"]["score_m2"], score.json()["score_m2"]);
    EXPECT_TRUE(std::filesystem::exists(folder_.path("out") / "scenario_months.csv"));
    EXPECT_EQ(atNoon("scenarios", {"--weights", "none", "--overwrite"}).code, 2);
}

// A building that stands on all of the region.
TEST_F(ScenariosCommand, AScenarioThatFailsIsNamedAndTheOthersGoOn) {
    done("add-scenario", {"Built over"});
    Project covered = opened();
    Scenario& scenario = covered.scenarios.back();
    ASSERT_EQ(scenario.name, "Built over");
    const Box2 park = bounds(covered.regions.front());
    Building hall = *noonmark::tests::buildingOf(
        noonmark::tests::Box3{{park.low.x - 1, park.low.y - 1, 0}, {park.high.x + 1, park.high.y + 1, 20}});
    hall.sourceId = "hall";
    scenario.edits.push_back(AddBuilding{std::make_shared<const Building>(std::move(hall))});
    ASSERT_TRUE(ProjectFile::open(file_).value().save(covered));
    const CommandOutput three = atNoon(
        "scenarios", {"--scenario", "Existing", "--scenario", "Built over", "--scenario", "Lower", "--json"});
    EXPECT_EQ(three.code, 1);
    EXPECT_THAT(three.err, testing::AllOf(HasSubstr("Built over"), HasSubstr("open ground")));
    EXPECT_THAT(namesIn(three.json()), ElementsAre("Existing", "Lower"));
    ASSERT_EQ(three.json()["failed"].size(), 1U);
    EXPECT_EQ(three.json()["failed"][0]["name"], "Built over");
    EXPECT_TRUE(std::filesystem::exists(folder_.path("out/scenarios.csv")));
    std::filesystem::remove_all(folder_.path("out"));
    const CommandOutput none = atNoon("scenarios", {"--scenario", "Built over"});
    EXPECT_EQ(none.code, 1);
    EXPECT_FALSE(std::filesystem::exists(folder_.path("out/scenarios.csv")));
}

TEST_F(ScenariosCommand, RefusesAnUnknownScenarioBeforeTheWork) {
    const CommandOutput unknown = atNoon("scenarios", {"--scenario", "Existing", "--scenario", "Nowhere"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("Nowhere"));
    const CommandOutput twice = atNoon("scenarios", {"--scenario", "Lower", "--scenario", "Lower"});
    EXPECT_EQ(twice.code, 2);
    EXPECT_THAT(twice.err, HasSubstr("named twice"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path("out")));
}

TEST_F(ScenariosCommand, TheImpactIsThatOfTheComparison) {
    const CommandOutput all = atNoon("scenarios", {"--baseline", "Existing", "--threshold", "10", "--json"});
    ASSERT_EQ(all.code, 0) << all.err;
    const CommandOutput impact = atNoon("impact", {"--to", "Lower", "--threshold", "10", "--json"});
    ASSERT_EQ(impact.code, 0) << impact.err;
    const auto scenarios = all.json().at("scenarios");
    EXPECT_TRUE(scenarios[0]["impact"].is_null()) << "the baseline changes nothing against itself";
    const auto& lower = scenarios.back();
    ASSERT_EQ(lower["name"], "Lower");
    const auto figures = impact.json().at("impact")[0];
    EXPECT_EQ(lower["impact"]["threshold_min"], 10);
    EXPECT_EQ(lower["impact"]["lost_m2"], figures["gross"]["lost_m2"]);
    EXPECT_LT(lower["impact"]["shadow_area_change_m2"], 0);
    // One name, one number: the table of scenarios states what the comparison does.
    EXPECT_DOUBLE_EQ(lower["impact"]["shadow_area_change_m2"], figures["shadow_area_change_m2"]);
    EXPECT_DOUBLE_EQ(lower["figures"]["shadow_area_change_m2"], figures["shadow_area_change_m2"]);
    EXPECT_EQ(atNoon("scenarios", {"--baseline", "Nowhere"}).code, 2);
}

// The folder alone, and the project as it is now.
TEST_F(ScenariosCommand, TheirRecordIsVerified) {
    const CommandOutput all =
        atNoon("scenarios", {"--by", "month", "--weights", "default", "--engine", "horizon", "--baseline",
                             "Existing", "--author", "A. Planner", "--landscape", "--with-project"});
    ASSERT_EQ(all.code, 0) << all.err;
    const auto verify = [&](const std::string& what) {
        return noonmarkCli({"verify", folder_.path(what).string(), "--json"});
    };
    for (const char* what : {"out", "out/scenarios.json", "out/scenarios.pdf"}) {
        const CommandOutput same = verify(what);
        EXPECT_EQ(same.code, 0) << what << same.err << same.out;
        EXPECT_GT(same.json()["figures"]["compared"], 100) << what;
        EXPECT_EQ(same.json()["tables"].size(), 3U) << what;
    }
    EXPECT_GT(verify("out").json()["pages"]["compared"], 3);

    std::filesystem::remove(folder_.path("out/park.noonmark.gpkg"));
    done("add-scenario", {"Later"});
    const CommandOutput later = verify("out");
    EXPECT_EQ(later.code, 0) << later.err << later.out;
    EXPECT_EQ(later.json()["inputs"][0]["saved_again"], true);

    done("height", {"One57", "--scenario", "Lower", "--height", "90"});
    EXPECT_EQ(verify("out").code, 2) << "another scenario than the recorded one";
}

TEST_F(ScenariosCommand, AForgedTableDoesNotAgree) {
    ASSERT_EQ(atNoon("scenarios", {"--scenario", "Existing", "--scenario", "Lower"}).code, 0);
    const auto table = folder_.path("out/scenarios.csv");
    std::string text = noonmark::tests::readBytes(table);
    const auto at = text.rfind("\nLower,2,");
    ASSERT_NE(at, text.npos) << text;
    text[at + 9] = text[at + 9] == '9' ? '8' : '9';
    std::ofstream(table, std::ios::binary) << text;
    const CommandOutput forged = noonmarkCli({"verify", folder_.path("out").string(), "--json"});
    EXPECT_EQ(forged.code, 1) << forged.err << forged.out;
    const auto tables = forged.json().at("tables");
    ASSERT_FALSE(tables.empty());
    EXPECT_EQ(tables.back()["name"], "scenarios.csv");
    EXPECT_EQ(tables.back()["differences"].size(), 1U);
}

TEST_F(ScenariosCommand, TheWidthOfAPictureIsChosen) {
    const CommandOutput impact = atNoon("impact", {"--to", "Lower", "--picture-width", "700"});
    ASSERT_EQ(impact.code, 0) << impact.err;
    EXPECT_EQ(QImageReader(QString::fromStdString(folder_.path("out/impact.png").string())).size().width(),
              700);
    EXPECT_EQ(atNoon("impact", {"--to", "Lower", "--picture-width", "20000"}).code, 2);
}

}  // namespace
}  // namespace noonmark::cli::tests
