#include "app/report/scenarios/scenario_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "app/report/files/read_report.h"
#include "app/report/scenarios/scenario_text.h"
#include "app/report/sheets/study_report.h"
#include "core/io/write_raster.h"
#include "tests/report/synthetic_study.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

/// The synthetic study twice; in the second, all cells have 30 minutes more.
ScenarioStudies makeTwoScenarios() {
    Study more = tests::syntheticStudy();
    for (float& minutes : more.field.grossMin) minutes += 30;
    more.statistics = computeStatistics(more.field);
    ProjectRecord record;
    record.scenario = {"Tower \"A\"", {"adds a building", "removes a building"}, {}};
    more.provenance.project = record;
    return {{"Existing", std::make_shared<const Study>(tests::syntheticStudy())},
            {"Tower \"A\"", std::make_shared<const Study>(std::move(more))}};
}

TEST(ScenarioTables, StateTheChangeFromTheFirst) {
    const ScenarioStudies two = makeTwoScenarios();
    const ShadowStatistics& first = two[0].study->statistics;
    // 30 of 360 sunlit minutes on every receiver.
    const double change = first.receiverAreaM2 * 30 / two[0].study->field.sunlitMinutesPerDay;
    EXPECT_NEAR(computeShadowAreaChange(two, two[1]), change, 0.01 * change);
    EXPECT_EQ(computeShadowAreaChange(two, two[0]), 0);
    EXPECT_EQ(countChanges(two[1]), 2U);
    const auto json = nlohmann::json::parse(scenariosJson(two));
    EXPECT_EQ(json["compared_with"], "Existing");
    ASSERT_EQ(json["scenarios"].size(), 2U);
    EXPECT_NEAR(json["scenarios"][1]["figures"]["shadow_area_change_m2"].get<double>(), change,
                0.01 * change);
    EXPECT_THAT(scenariosCsv(two), HasSubstr("\r\n\"Tower \"\"A\"\"\",2,"));
}

TEST(ScenarioTables, StateTheFloorAreaByUse) {
    ScenarioStudies two = makeTwoScenarios();
    two[1].uses = {{{"homes, rented", 9, 1800}, {"", 3, 600}}, 1};
    EXPECT_EQ(scenarioUsesCsv(two),
              "scenario,use,storeys,gross_floor_m2\r\n\"Tower \"\"A\"\"\",\"homes, rented\",9,1800.0\r\n"
              "\"Tower \"\"A\"\"\",,3,600.0\r\n");
    const auto json = nlohmann::json::parse(scenariosJson(two));
    EXPECT_TRUE(json["scenarios"][0]["floor_area_by_use"].empty());
    EXPECT_EQ(json["scenarios"][1]["floor_area_by_use"][0]["storeys"], 9);
    EXPECT_TRUE(json["scenarios"][1]["floor_area_by_use"][1]["use"].is_null());
    EXPECT_EQ(json["scenarios"][1]["towers_not_counted_by_use"], 1);
}

/// The fields of the last line by the names of the first one; no field holds a comma.
std::map<std::string, std::string> lastFieldsOf(const std::string& csv) {
    const QStringList lines = QString::fromStdString(csv).trimmed().split(QStringLiteral("\r\n"));
    const QStringList names = lines.first().split(u','), fields = lines.last().split(u',');
    std::map<std::string, std::string> byName;
    for (qsizetype i = 0; i < names.size(); ++i)
        byName[names[i].toStdString()] = fields.value(i).toStdString();
    return byName;
}

TEST(ScenarioTables, StateHeightImpactScoreAndVerdictsOrLeaveThemEmpty) {
    ScenarioStudies two = makeTwoScenarios();
    const auto without = lastFieldsOf(scenariosCsv(two));
    for (const char* name :
         {"height_m", "gross_floor_m2", "impact_baseline", "impact_m2", "score_m2", "fail"})
        EXPECT_EQ(without.at(name), "") << name;
    EXPECT_TRUE(nlohmann::json::parse(scenariosJson(two))["scenarios"][1]["impact"].is_null());
    ScenarioStudy& tower = two[1];
    tower.uses = {{{"homes", 9, 1800}, {"", 3, 600}}, 0};
    tower.heightM = 42;
    tower.answers.impact = ScenarioImpact{"Existing", {}};
    tower.answers.impact->figures.shadowAreaChangeM2 = -12.5;
    tower.answers.impact->figures.gross.gainedM2 = 80;
    tower.answers.score = ScenarioScore{"default", {-340.25, -1234.5}};
    tower.answers.verdicts = ScenarioVerdicts{"Boston Common", "Existing", {12, 1, 3, 2}};
    const auto fields = lastFieldsOf(scenariosCsv(two));
    for (const auto& [name, text] : std::map<std::string, std::string>{{"height_m", "42.0"},
                                                                       {"gross_floor_m2", "2400.0"},
                                                                       {"impact_baseline", "Existing"},
                                                                       {"impact_m2", "-12.5"},
                                                                       {"impact_threshold_min", "30"},
                                                                       {"gained_m2", "80.0"},
                                                                       {"lost_m2", "0.0"},
                                                                       {"weights", "default"},
                                                                       {"weighted_shade_m2h", "-1234.5"},
                                                                       {"score_m2", "-340.2"},
                                                                       {"rule", "Boston Common"},
                                                                       {"pass", "12"},
                                                                       {"borderline", "1"},
                                                                       {"fail", "3"},
                                                                       {"not_judged", "2"}})
        EXPECT_EQ(fields.at(name), text) << name;
    const auto json = nlohmann::json::parse(scenariosJson(two))["scenarios"][1];
    EXPECT_EQ(json["height_m"], 42);
    EXPECT_EQ(json["gross_floor_m2"], 2400);
    EXPECT_EQ(json["impact"]["gained_m2"], 80);
    EXPECT_EQ(json["score"]["score_m2"], -340.25);
    EXPECT_EQ(json["score"]["weighted_shade_m2h"], -1234.5);
    EXPECT_EQ(json["verdicts"]["fail"], 3);
}

TEST(ScenarioTables, LeaveContinuousShadowOutWhereItWasNotCounted) {
    const ScenarioStudies one{
        {"Existing", std::make_shared<const Study>(tests::grossOnly(tests::syntheticStudy()))}};
    const auto json = nlohmann::json::parse(scenariosJson(one));
    EXPECT_TRUE(json["scenarios"][0]["figures"]["mean_continuous_min"].is_null());
    EXPECT_THAT(scenariosCsv(one), testing::Not(HasSubstr("nan")));
}

TEST(ScenarioFiles, AreOneSetWithABandForEachScenario) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    const ScenarioStudies two = makeTwoScenarios();
    const auto paths = writeScenarioFiles(two, {}, out);
    ASSERT_TRUE(paths) << paths.error().text();
    ASSERT_EQ(paths->size(), scenarioFileNames().size());
    const auto bands = readGeoTiff(out / "scenarios.tif", two[0].study->field.grid);
    ASSERT_TRUE(bands) << bands.error().text();
    ASSERT_EQ(bands->size(), 2U);
    EXPECT_EQ((*bands)[1][5], (*bands)[0][5] + 30);
    const auto words = readPrintedWords(out / "scenarios.pdf");
    ASSERT_TRUE(words) << words.error().text();
    for (const char* word : {"Existing", "Tower", "Change"}) EXPECT_THAT(*words, HasSubstr(word));
}

TEST(ScenarioFiles, AreRefusedWithoutScenariosOrOnDifferentCells) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    EXPECT_FALSE(writeScenarioFiles({}, {}, out));
    ScenarioStudies two = makeTwoScenarios();
    auto other = std::make_shared<Study>(*two[1].study);
    other->field.grid.cellM = 2;
    two[1].study = other;
    EXPECT_FALSE(writeScenarioFiles(two, {}, out));
    EXPECT_FALSE(std::filesystem::exists(out / "scenarios.csv"));
}

TEST(Pictures, AreAsWideAsAskedAndShowTheSameAtEverySize) {
    const Study study = tests::syntheticStudy();
    const QImage usual = mapPicture(study, ShadowMeasure::gross);
    const QImage large = mapPicture(study, ShadowMeasure::gross, 2 * pictureWidth);
    EXPECT_EQ(usual.width(), pictureWidth);
    EXPECT_EQ(large.width(), 2 * pictureWidth);
    EXPECT_NEAR(large.height(), 2 * usual.height(), 2);
    const QImage shrunk = large.scaled(usual.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    int far = 0;
    for (int y = 0; y < usual.height(); y += 5)
        for (int x = 0; x < usual.width(); x += 5)
            far += std::abs(qGreen(usual.pixel(x, y)) - qGreen(shrunk.pixel(x, y))) > 60 ? 1 : 0;
    EXPECT_LT(far, usual.width() * usual.height() / 25 / 50) << "two in a hundred: edges of letters";
    EXPECT_EQ(mapPicture(study, ShadowMeasure::gross, 1).width(), minPictureWidth);
}

}  // namespace
}  // namespace noonmark
