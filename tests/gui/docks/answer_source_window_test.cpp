#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QSettings>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/gui/docks/results/results_dock.h"
#include "app/gui/frame/main_window.h"
#include "app/gui/session/answers/measured_answers.h"
#include "tests/gui/small_project.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;
using testing::HasSubstr;

/// The window with a saved project whose city has a reading warning, a scenario, and a quick study.
struct AnswerSourceWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    std::unique_ptr<MainWindow> window;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        Project project = test::smallProject();
        project.scenarios.push_back({"Tower", "", {test::newTower("New", 70)}});
        project.inputs = {{"small.gpkg", 7, "abc"}};
        project.reading = std::make_shared<const CityReading>(
            CityReading{ReadSettings{}, {{WarningKind::repaired, "outline crossed itself", "way 7"}}});
        const QString file = folder.filePath(QStringLiteral("small.noonmark.gpkg"));
        ASSERT_TRUE(ProjectFile::create(file.toStdString(), project));
        window = std::make_unique<MainWindow>(settings);
        window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
        window->show();
        window->open({file});
        ASSERT_TRUE(waitFor([&] { return workbench().city() != nullptr; }));
        StudySettings question = workbench().document().settings();
        question.receivers.cellM = 4;
        question.period.stepMinutes = 30;
        question.region = session().project().regions[0];
        workbench().document().change(question, QStringLiteral("test"));
    }

    Workbench& workbench() { return window->workbench(); }
    ProjectSession& session() { return workbench().session(); }

    std::string firstWarning() {
        return window->findChild<WarningsDock*>()->topLevelItem(0)->text(0).toStdString();
    }

    void goTo(const char* scenario) {
        session().goTo(scenario);
        ASSERT_TRUE(waitFor([&] { return !workbench().following().busy(); }));
    }

    void study() {
        workbench().run();
        ASSERT_TRUE(waitFor([this] { return workbench().study() && !workbench().running().busy(); }));
    }

    nlohmann::json exported() {
        const QTemporaryDir out;
        workbench().exportShown(out.path().toStdString(), {});
        EXPECT_TRUE(waitFor([this] { return !workbench().writing().busy(); }));
        std::ifstream stream(out.filePath(QStringLiteral("study.json")).toStdString());
        return nlohmann::json::parse(stream);
    }
};

TEST_F(AnswerSourceWindow, AReportOfAScenarioNamesItAndRepeatsIt) {
    goTo("Tower");
    study();
    const auto json = exported();
    EXPECT_EQ(json["scenario"], "Tower");
    EXPECT_EQ(json["scenario_edits"].size(), 1U);
    EXPECT_TRUE(json["project"]["saved_as_measured"].get<bool>());
    EXPECT_THAT(json["repeat"].get<std::string>(),
                HasSubstr("noonmark-cli study small.noonmark.gpkg --scenario Tower"));
    EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--region Square"));
    EXPECT_EQ(json["warnings"][0]["where"][0], "way 7");
}

TEST_F(AnswerSourceWindow, WhatIsNotSavedHasNoCommandUntilItIs) {
    goTo("Tower");
    ASSERT_TRUE(session().addEdits({test::newTower("Newer", 40)}, QStringLiteral("test")));
    ASSERT_TRUE(waitFor([&] { return !workbench().following().busy(); }));
    study();
    const auto unsaved = exported();
    EXPECT_TRUE(unsaved["repeat"].is_null()) << unsaved["repeat"];
    EXPECT_THAT(unsaved["repeat_note"].get<std::string>(), HasSubstr("Save the project"));
    EXPECT_EQ(unsaved["scenario"], "Tower");
    EXPECT_EQ(unsaved["scenario_edits"].size(), 2U);
    EXPECT_TRUE(unsaved["project"]["file_sha256"].is_null());
    ProjectFile disk = *session().file();
    ASSERT_TRUE(disk.save(session().project()));
    session().setSaved(disk, session().version());
    const auto saved = exported();
    EXPECT_TRUE(saved["repeat"].is_string());
    EXPECT_EQ(saved["project"]["content_sha256"], unsaved["project"]["content_sha256"]);
}

TEST_F(AnswerSourceWindow, AFileThatSomeoneElseSavedRepeatsNothing) {
    ProjectFile other = ProjectFile::open(session().file()->path()).value();
    ASSERT_TRUE(other.save(other.project()));
    goTo("Tower");
    study();
    EXPECT_TRUE(exported()["repeat"].is_null());
}

TEST_F(AnswerSourceWindow, WarningsOfReadingStayWithEveryAnswer) {
    EXPECT_THAT(firstWarning(), HasSubstr("outline crossed itself"));
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
    EXPECT_THAT(firstWarning(), HasSubstr("outline crossed itself"));
    goTo("Tower");
    session().compareWith(existingCity);
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    EXPECT_THAT(firstWarning(), HasSubstr("outline crossed itself"));
}

TEST_F(AnswerSourceWindow, AComparisonAndAScoreNameTheirScenarios) {
    goTo("Tower");
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
    const auto stated = AnswerOrigin(session()).stated(workbench().answer());
    const auto json = nlohmann::json::parse(stated->json());
    EXPECT_THAT(json["repeat"].get<std::string>(),
                HasSubstr("noonmark-cli score small.noonmark.gpkg --scenario Tower"));
    session().compareWith(existingCity);
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    const auto compared = nlohmann::json::parse(AnswerOrigin(session()).stated(workbench().answer())->json());
    EXPECT_THAT(compared["repeat"].get<std::string>(), HasSubstr("--from Existing --to Tower"));
    EXPECT_EQ(compared["baseline"], "Existing");
    EXPECT_EQ(compared["warnings"][0]["where"][0], "way 7");
}

}  // namespace
}  // namespace noonmark
