#include "app/report/scenarios/scenario_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/report/files/read_report.h"
#include "app/report/scenarios/scenario_months.h"
#include "app/report/scenarios/scenario_study.h"
#include "app/report/sheets/study_report.h"
#include "core/io/write_raster.h"
#include "tests/report/book/book_texts.h"
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

// Ground that is built over is no receiver of both: without shadow on it, the sum of the shadow falls by what
// lay there, but nothing that a comparison counts has changed.
TEST(ScenarioTables, TheChangeLeavesOutWhatIsBuiltOver) {
    ScenarioStudies two = makeTwoScenarios();
    Study built = tests::syntheticStudy();
    const auto covered = std::ranges::max_element(
        built.field.grossMin, {}, [](float minutes) { return std::isnan(minutes) ? -1.0F : minutes; });
    ASSERT_GT(*covered, 0);
    *covered = std::numeric_limits<float>::quiet_NaN();
    built.statistics = computeStatistics(built.field);
    two[1].study = std::make_shared<const Study>(std::move(built));
    EXPECT_LT(two[1].study->statistics.shadowAreaM2, two[0].study->statistics.shadowAreaM2);
    EXPECT_EQ(computeShadowAreaChange(two, two[1]), 0);
}

TEST(ScenarioTables, CannotBeRepeatedWhereOnlySomeAreScored) {
    ScenarioStudies two = makeTwoScenarios();
    for (ScenarioStudy& one : two) {
        Study saved = *one.study;
        ProjectRecord record{.file = "town.noonmark.gpkg", .fileSha256 = "ab", .contentSha256 = "cd"};
        record.scenario.name = one.name;
        saved.provenance.project = record;
        saved.provenance.region = "Park";
        one.study = std::make_shared<const Study>(std::move(saved));
    }
    const auto command = makeRepeatCommand(two);
    ASSERT_TRUE(command) << command.error().text();
    EXPECT_THAT(*command, testing::AllOf(HasSubstr("noonmark-cli scenarios town.noonmark.gpkg"),
                                         HasSubstr("--scenario Existing"), HasSubstr("--region Park"),
                                         HasSubstr("--out repeated")));
    two[1].answers.score = ScenarioScore{"default", {}};
    const auto some = makeRepeatCommand(two);
    ASSERT_FALSE(some);
    EXPECT_THAT(some.error().text(), testing::AllOf(HasSubstr("scored"), HasSubstr("Score all")));
    two[0].answers.score = ScenarioScore{"default", {}};
    two[1].answers.impact = ScenarioImpact{"Existing", {}};
    EXPECT_THAT(makeRepeatCommand(two).value(),
                testing::AllOf(HasSubstr("--weights default"), HasSubstr("--baseline Existing"),
                               HasSubstr("--threshold 30")));
    two[1].withTrees = {{TreeColumns::seasonal, two[1].study->statistics}};
    const auto withTrees = makeRepeatCommand(two);
    ASSERT_FALSE(withTrees) << "the scenario alone has trees, and its score does not count them";
    EXPECT_THAT(withTrees.error().text(), HasSubstr("its scores without"));
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
    tower.answers.impact->figures.gross.moreShadowM2 = 80;
    tower.answers.score = ScenarioScore{"default", {.scoreM2 = -340.25, .weightedShadeM2h = -1234.5}};
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

TEST(ScenarioBook, ShowsAllScenariosOnItsFirstPageWithHeightAndFloorArea) {
    ScenarioStudies two = makeTwoScenarios();
    two[1].uses = {{{"homes", 9, 1800}, {"", 3, 600}}, 0};
    two[1].heightM = 42;
    for (const bool landscape : {false, true}) {
        const Book book = makeScenarioBook(two, {{Paper::a4, landscape}, {}, {}});
        const QString text = tests::textOfPage(book, 0);
        for (const char* part : {"Existing", "Tower", "42.0 m high", "floor area 2,400 m²"})
            EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << ": " << text.toStdString();
        for (std::size_t i = 0; i < book.pages.size(); ++i)
            EXPECT_THAT(tests::listMeetings(tests::textsOfPage(book, i)), testing::IsEmpty()) << "page " << i;
    }
}

// All maps show the same ground: the cells around (15, 15) m, where the second scenario has more shadow.
TEST(ScenarioBook, ShowsCloselyWhereScenariosDiffer) {
    const Study first = tests::syntheticStudy();
    Study more = first;
    const Grid& grid = more.field.grid;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            if (const glm::dvec2 at = grid.centre(column, row);
                std::abs(at.x - 15) < 5 && std::abs(at.y - 15) < 5)
                more.field.grossMin[grid.index(column, row)] += 40;
    const ScenarioStudies two{{"Existing", std::make_shared<const Study>(first)},
                              {"Tower", std::make_shared<const Study>(std::move(more))}};
    const Book book = makeScenarioBook(two, {});
    for (const PageItem& item : book.pages[0].items) {
        const auto& shown = std::get<PageMap>(item.content).map->scene.shown;
        ASSERT_TRUE(shown);
        EXPECT_EQ(*shown, (Box2{{0, 0}, {45, 45}})) << "60 m around (15, 15), cut to the region";
    }
    for (std::size_t i = 0; i < book.pages.size(); ++i)
        EXPECT_FALSE(tests::textOfPage(book, i).contains(QChar(0x2026))) << "a text is cut on page " << i;
    const QString dashed = QStringLiteral("dashed: open below");
    EXPECT_FALSE(tests::textOfPage(book, 0).contains(dashed)) << "the overhang lies farther north";
    const auto map = std::ranges::find(book.pages, QStringLiteral("Tower"), &BookPage::title);
    ASSERT_NE(map, book.pages.end());
    EXPECT_TRUE(tests::textOfPage(book, std::size_t(map - book.pages.begin())).contains(dashed))
        << "the map of the region";
}

TEST(ScenarioTables, LeaveContinuousShadowOutWhereItWasNotCounted) {
    const ScenarioStudies one{
        {"Existing", std::make_shared<const Study>(tests::grossOnly(tests::syntheticStudy()))}};
    const auto json = nlohmann::json::parse(scenariosJson(one));
    EXPECT_TRUE(json["scenarios"][0]["figures"]["mean_continuous_min"].is_null());
    EXPECT_THAT(scenariosCsv(one), testing::Not(HasSubstr("nan")));
}

Score scoreOf(double january, double february) {
    using namespace std::chrono;
    Score score;
    score.months = {{2026y / January, 100, january, 600, 50}, {2026y / February, 200, february, 600, 80}};
    return score;
}

ScenarioStudies scoredScenarios() {
    ScenarioStudies three = makeTwoScenarios();
    three.push_back({"Not scored", three[0].study});
    three[0].answers.score = ScenarioScore{"default", {}, scoreOf(-10, 5).months};
    three[1].answers.score = ScenarioScore{"default", {}, scoreOf(-12.5, 9).months};
    return three;
}

TEST(ScenarioMonths, StandSideBySideWithTheirChangesFromTheFirst) {
    const auto charts = makeMonthCharts(listMonths(scoredScenarios()));
    ASSERT_EQ(charts.size(), 3U) << "shadow area, weighted shade and score; the studies have no months";
    const MonthChart& score = charts[2];
    EXPECT_EQ(score.key, "score_m2");
    EXPECT_EQ(score.values.series, (std::vector<std::string>{"Existing", "Tower \"A\""}));
    EXPECT_EQ(score.values.groups[1].values, (std::vector<double>{5, 9}));
    EXPECT_EQ(score.changes.groups[0].values, (std::vector<double>{-2.5}));
    EXPECT_EQ(monthsCsv(charts),
              "scenario,month,shadow_area_m2,shadow_area_change_m2,weighted_shade_m2h,"
              "weighted_shade_change_m2h,score_m2,score_change_m2\r\n"
              "Existing,2026-01,100.0,,50.0,,-10.0,\r\nExisting,2026-02,200.0,,80.0,,5.0,\r\n"
              "\"Tower \"\"A\"\"\",2026-01,100.0,0.0,50.0,0.0,-12.5,-2.5\r\n"
              "\"Tower \"\"A\"\"\",2026-02,200.0,0.0,80.0,0.0,9.0,4.0\r\n");
}

TEST(ScenarioMonths, HaveNoChangesWhereTheFirstScenarioLacksThem) {
    ScenarioStudies three = scoredScenarios();
    std::swap(three[0], three[2]);
    const auto charts = makeMonthCharts(listMonths(three));
    ASSERT_EQ(charts.size(), 3U);
    EXPECT_TRUE(charts[2].changes.groups.empty()) << "a change from another one than stated would mislead";
}

TEST(ScenarioMonths, AreInTheRecordAndTheSheets) {
    const ScenarioStudies three = scoredScenarios();
    const auto json = nlohmann::json::parse(scenariosJson(three));
    const auto& tower = json["scenarios"][1]["months"];
    ASSERT_EQ(tower.size(), 2U);
    EXPECT_EQ(tower[1]["month"], "2026-02");
    EXPECT_EQ(tower[1]["score_change_m2"], 4);
    EXPECT_TRUE(json["scenarios"][2]["months"][0]["score_m2"].is_null());
    EXPECT_TRUE(json["definitions"].contains("score_m2"));
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    const auto paths = writeScenarioFiles(three, {}, out);
    ASSERT_TRUE(paths) << paths.error().text();
    EXPECT_TRUE(std::filesystem::exists(out / "scenario_months.csv"));
    const auto words = readPrintedWords(out / "scenarios.pdf");
    ASSERT_TRUE(words) << words.error().text();
    EXPECT_THAT(*words, HasSubstr("score"));
}

TEST(ScenarioFiles, AreOneSetWithABandForEachScenario) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    const ScenarioStudies two = makeTwoScenarios();
    const auto paths = writeScenarioFiles(two, {}, out);
    ASSERT_TRUE(paths) << paths.error().text();
    ASSERT_EQ(paths->size(), scenarioFileNames().size() - 2)
        << "all but the months, which were not computed, and the region, which no command names";
    const auto bands = readGeoTiff(out / "scenarios.tif", two[0].study->field.grid);
    ASSERT_TRUE(bands) << bands.error().text();
    ASSERT_EQ(bands->size(), 2U);
    EXPECT_EQ((*bands)[1][5], (*bands)[0][5] + 30);
    const auto words = readPrintedWords(out / "scenarios.pdf");
    ASSERT_TRUE(words) << words.error().text();
    for (const char* word : {"Existing", "Tower", "Change"}) EXPECT_THAT(*words, HasSubstr(word));
}

TEST(ScenarioFiles, HaveTheLegendThatWasChosenOnSheetsAndInTheStyleForQgis) {
    const QTemporaryDir folder;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    const LegendClasses classes{LegendClasses::Kind::breaks, 5, {2, 4}};
    ASSERT_TRUE(
        writeScenarioFiles(makeTwoScenarios(), {.legend = {.show = ShownAs::sun, .classes = classes}}, out));
    QFile style(QString::fromStdString((out / "scenarios.qml").string()));
    ASSERT_TRUE(style.open(QIODevice::ReadOnly));
    EXPECT_THAT(style.readAll().toStdString(), HasSubstr("2 to 4 h"));
    const auto words = readPrintedWords(out / "scenarios.pdf");
    ASSERT_TRUE(words) << words.error().text();
    EXPECT_THAT(*words, HasSubstr("Hours of sun"));
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
    const QImage standard = mapPicture(study, ShadowMeasure::gross);
    const QImage large = mapPicture(study, ShadowMeasure::gross, 2 * pictureWidth);
    EXPECT_EQ(standard.width(), pictureWidth);
    EXPECT_EQ(large.width(), 2 * pictureWidth);
    EXPECT_NEAR(large.height(), 2 * standard.height(), 2);
    const QImage shrunk = large.scaled(standard.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    int far = 0;
    for (int y = 0; y < standard.height(); y += 5)
        for (int x = 0; x < standard.width(); x += 5)
            far += std::abs(qGreen(standard.pixel(x, y)) - qGreen(shrunk.pixel(x, y))) > 60 ? 1 : 0;
    EXPECT_LT(far, standard.width() * standard.height() / 25 / 50) << "two in a hundred: edges of letters";
    EXPECT_EQ(mapPicture(study, ShadowMeasure::gross, 1).width(), minPictureWidth);
}

}  // namespace
}  // namespace noonmark
