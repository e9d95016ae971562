#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>

#include "app/window/frame/main_window.h"
#include "app/window/project/project_session.h"
#include "app/window/project/recovery_store.h"
#include "app/window/study/warning_place.h"
#include "app/window/study/warnings_dock.h"
#include "app/window/view/view_panel.h"
#include "scenarios/project/recovery_file.h"
#include "tests/gui/small_project.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::newTower;
using test::waitFor;

QByteArray bytesOf(const QString& name) {
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
}

/// The window with a small project file.
struct ProjectWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    QString file = folder.filePath(QStringLiteral("small.noonmark.gpkg"));
    std::unique_ptr<MainWindow> window;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        ASSERT_TRUE(ProjectFile::create(file.toStdString(), test::smallProject()));
        makeWindow();
        open(file);
    }

    void makeWindow() {
        window.reset();
        window = std::make_unique<MainWindow>(settings);
        window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
        window->resize(900, 600);
        window->show();
    }
    void open(const QString& name) {
        const auto before = workbench().city();
        window->open({name});
        ASSERT_TRUE(waitFor([&] { return workbench().city() != before; })) << message().toStdString();
    }
    void build() {
        ASSERT_TRUE(session().addEdits({newTower("New", 70)}, QStringLiteral("tower")));
        ASSERT_TRUE(waitFor([this] { return workbench().city()->city().buildings.size() == 4; }));
    }
    void save() {
        window->saving().save();
        ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    }
    [[nodiscard]] std::filesystem::path recovery() const { return recoveryPath(file.toStdString()); }
    void keepUnsaved() {
        window->saving().keepUnsaved();
        ASSERT_TRUE(waitFor([this] { return std::filesystem::exists(recovery()); }));
    }
    Workbench& workbench() { return window->workbench(); }
    ProjectSession& session() { return workbench().session(); }
    QString message() { return window->panel().messages().text(); }
    void takeOffer() {
        window->panel().messages().findChild<QPushButton*>(QStringLiteral("remedy"))->click();
    }
    // Ends the window as a crash would: without questions or cleaning up.
    void kill() { window.reset(); }
};

TEST_F(ProjectWindow, EditsAreShownSavedAndFoundAgain) {
    const CameraPose pose{{3, 4, 0}, 321, 40, 50};
    window->panel().view().setPose(pose);
    build();
    EXPECT_EQ(window->panel().view().pose(), pose) << "the camera stays";
    EXPECT_TRUE(window->isWindowModified());
    save();
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("small[*]")));
    makeWindow();
    open(file);
    EXPECT_EQ(session().scenario(), "Proposal A");
    EXPECT_EQ(workbench().city()->city().buildings.size(), 4U);
    EXPECT_EQ(window->panel().view().pose(), pose);
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ProjectWindow, TheQuestionIsFoundAgain) {
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 5;
    question.region = session().project().regions[0];
    question.period.window =
        SolarWindow{std::chrono::minutes(90), std::chrono::minutes(30), SunriseRule::centre};
    question.period.zone = "America/New_York";
    workbench().document().change(question, QStringLiteral("test"));
    EXPECT_TRUE(session().hasUnsavedWork()) << "the project has a file, which stores the settings";
    save();
    makeWindow();
    open(file);
    EXPECT_EQ(workbench().document().settings(), question);
}

TEST_F(ProjectWindow, SavedStateIsReachedByUndo) {
    build();
    save();
    workbench().document().undoStack().undo();
    EXPECT_TRUE(session().hasUnsavedWork());
    workbench().document().undoStack().redo();
    EXPECT_FALSE(session().hasUnsavedWork());
    save();
    EXPECT_EQ(ProjectFile::open(file.toStdString()).value().saves(), 3);
}

TEST_F(ProjectWindow, UnsavedWorkIsAskedAboutBeforeAnotherIsOpenedOrTheWindowClosed) {
    build();
    int asked = 0;
    window->saving().setUnsavedQuestion([&] { return ++asked, SavingActions::Unsaved::cancel; });
    window->open({QStringLiteral("sample:central-park-south")});
    EXPECT_FALSE(workbench().opening().busy());
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked, 2);
    window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::save; });
    window->close();
    ASSERT_TRUE(waitFor([this] { return !window->isVisible(); }));
    EXPECT_EQ(ProjectFile::open(file.toStdString()).value().project().scenarios.size(), 1U);
}

TEST_F(ProjectWindow, QuitAndDiscardClosesAtOnceAndForgetsTheWork) {
    build();
    keepUnsaved();
    int asked = 0;
    window->saving().setUnsavedQuestion([&] { return ++asked, SavingActions::Unsaved::discard; });
    EXPECT_TRUE(window->close());
    EXPECT_FALSE(window->isVisible());
    EXPECT_EQ(asked, 1);
    EXPECT_FALSE(std::filesystem::exists(recovery()));
}

TEST_F(ProjectWindow, AQuitThatIsCancelledIsAskedAboutAgainAndLosesNothing) {
    build();
    int asked = 0;
    SavingActions::Unsaved answer = SavingActions::Unsaved::cancel;
    window->saving().setUnsavedQuestion([&] { return ++asked, answer; });
    for (int quit = 1; quit <= 3; ++quit) {
        EXPECT_FALSE(window->close());
        EXPECT_TRUE(window->isVisible());
        EXPECT_EQ(asked, quit);
        ASSERT_TRUE(session().addLot({"Lot", test::square({0, 0}, 10)})) << "work after the quit";
        keepUnsaved();
        EXPECT_TRUE(std::filesystem::exists(recovery()));
    }
    answer = SavingActions::Unsaved::discard;
    EXPECT_TRUE(window->close());
    EXPECT_FALSE(window->isVisible());
}

TEST_F(ProjectWindow, AQuitWhoseSaveFailsStaysOpenAndAsksAgain) {
    build();
    keepUnsaved();
    auto other = ProjectFile::open(file.toStdString()).value();
    ASSERT_TRUE(other.save(other.project()));  // saved by another program: this window's save is refused
    int asked = 0;
    window->saving().setUnsavedQuestion([&] { return ++asked, SavingActions::Unsaved::save; });
    for (int quit = 1; quit <= 2; ++quit) {
        window->panel().messages().hide();
        EXPECT_FALSE(window->close());
        ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
        EXPECT_TRUE(window->isVisible());
        EXPECT_EQ(asked, quit);
        EXPECT_TRUE(std::filesystem::exists(recovery()));
    }
    ASSERT_TRUE(session().addLot({"Lot", test::square({0, 0}, 10)}));
    keepUnsaved();
    window->saving().setUnsavedQuestion([&] { return ++asked, SavingActions::Unsaved::cancel; });
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked, 3) << "the failed quit has no later effect";
    EXPECT_TRUE(std::filesystem::exists(recovery()));
}

TEST_F(ProjectWindow, AQuitWhoseSaveAsIsCancelledStaysOpenAndALaterSaveDoesNotClose) {
    open(QStringLiteral("sample:central-park-south"));
    ASSERT_TRUE(session().addLot({"Mine", test::square({0, 0}, 10)}));
    window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::save; });
    const QString name = folder.filePath(QStringLiteral("mine.noonmark.gpkg"));
    QString chosen;
    window->saving().setSaveAsQuestion([&](const QString&) { return chosen; });
    EXPECT_FALSE(window->close());
    EXPECT_FALSE(window->saving().writing().busy());
    EXPECT_TRUE(window->isVisible());
    window->saving().saveTo(name.toStdString());
    ASSERT_TRUE(waitFor([this] { return session().file().has_value(); }));
    EXPECT_TRUE(window->isVisible()) << "cancelling the dialog cancelled the quit";
    ASSERT_TRUE(session().addLot({"Mine too", test::square({0, 0}, 10)}));
    const std::size_t lots = session().project().lots.size();
    EXPECT_FALSE(window->close()) << "it is being saved";
    ASSERT_TRUE(waitFor([this] { return !window->isVisible(); }));
    EXPECT_EQ(ProjectFile::open(name.toStdString()).value().project().lots.size(), lots);
}

TEST_F(ProjectWindow, WorkDoneWhileAQuitSavesIsAskedAboutAndACancelledSecondQuitEndsTheFirst) {
    build();
    int asked = 0;
    window->saving().setUnsavedQuestion(
        [&] { return ++asked == 1 ? SavingActions::Unsaved::save : SavingActions::Unsaved::cancel; });
    EXPECT_FALSE(window->close());
    ASSERT_TRUE(session().addLot({"Lot", test::square({0, 0}, 10)}));
    ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    EXPECT_EQ(asked, 2);
    EXPECT_TRUE(window->isVisible());
    asked = 0;
    EXPECT_FALSE(window->close());
    EXPECT_FALSE(window->close()) << "asked and cancelled while the first one saves";
    ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    EXPECT_EQ(asked, 2);
    EXPECT_TRUE(window->isVisible());
    EXPECT_TRUE(window->close()) << "all is saved";
}

TEST_F(ProjectWindow, WorkDiscardedForAFileThatCannotBeOpenedIsStillRecoverable) {
    build();
    keepUnsaved();
    window->open({folder.filePath(QStringLiteral("missing.noonmark.gpkg"))});
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    EXPECT_TRUE(session().hasUnsavedWork());
    EXPECT_TRUE(waitFor([this] { return std::filesystem::exists(recovery()); }));
}

TEST_F(ProjectWindow, WorkThatWasNotSavedIsOfferedAgain) {
    build();
    window->saving().keepUnsaved();
    const std::filesystem::path saved = recoveryPath(file.toStdString());
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(saved); }));
    kill();
    makeWindow();
    open(file);
    EXPECT_TRUE(session().project().scenarios.empty());
    ASSERT_FALSE(message().isEmpty());
    takeOffer();
    ASSERT_TRUE(waitFor([this] { return session().project().scenarios.size() == 1; }));
    EXPECT_TRUE(session().hasUnsavedWork());
    ASSERT_TRUE(waitFor([this] { return workbench().city()->city().buildings.size() == 4; }));
    workbench().document().undoStack().undo();
    EXPECT_TRUE(session().project().scenarios.empty());
    workbench().document().undoStack().redo();
    save();
    EXPECT_EQ(ProjectFile::open(file.toStdString()).value().project().scenarios.size(), 1U);
}

TEST_F(ProjectWindow, WorkThatNeverHadAFileIsOfferedAgain) {
    open(QStringLiteral("sample:central-park-south"));
    ASSERT_TRUE(session().addLot({"Mine", test::square({0, 0}, 10)}));
    const std::size_t lots = session().project().lots.size();
    window->saving().keepUnsaved();
    const QString unsaved = folder.filePath(QStringLiteral("unsaved"));
    const std::filesystem::path saved =
        recoveryPath((unsaved + QStringLiteral("/Untitled 1.noonmark.gpkg")).toStdString());
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(saved); }));
    kill();
    makeWindow();
    open(QStringLiteral("sample:central-park-south"));
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    takeOffer();
    ASSERT_TRUE(waitFor([&] { return session().project().lots.size() == lots; }));
    EXPECT_TRUE(waitFor([this] { return session().hasUnsavedWork(); }));
    EXPECT_FALSE(session().file());
}

TEST_F(ProjectWindow, RecoveredWorkThatIsDiscardedIsNotOfferedAgain) {
    const QString sample = QStringLiteral("sample:central-park-south");
    open(sample);
    ASSERT_TRUE(session().addLot({"Mine", test::square({0, 0}, 10)}));
    window->saving().keepUnsaved();
    const QDir unsaved(folder.filePath(QStringLiteral("unsaved")));
    const auto saved = [&] {
        return unsaved.entryList({QStringLiteral("*.gpkg")}, QDir::Files | QDir::Hidden);
    };
    ASSERT_TRUE(waitFor([&] { return !saved().isEmpty() && !window->saving().writing().busy(); }));
    kill();
    makeWindow();
    open(sample);
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    takeOffer();
    ASSERT_TRUE(waitFor([this] { return session().recovered(); }));
    open(sample);  // the question is answered by Discard
    EXPECT_EQ(message(), QString());
    kill();
    EXPECT_EQ(saved(), QStringList());
    makeWindow();
    open(sample);
    EXPECT_EQ(message(), QString());
}

TEST_F(ProjectWindow, RecoveredChangesOfAFileThatAreDiscardedAreNotOfferedAgain) {
    build();
    window->saving().keepUnsaved();
    const std::filesystem::path saved = recoveryPath(file.toStdString());
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(saved); }));
    for (const bool keptAgain : {false, true}) {
        kill();
        makeWindow();
        open(file);
        takeOffer();
        ASSERT_TRUE(waitFor([this] { return session().project().scenarios.size() == 1; }));
        const auto older = ProjectSaving::olderRecovery(file.toStdString());
        if (keptAgain) window->saving().keepUnsaved();
        if (keptAgain) {
            ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(saved); }));
            EXPECT_TRUE(std::filesystem::exists(older));
        }
        const auto copy = saved.string() + ".copy";
        std::filesystem::copy_file(keptAgain ? older : saved, copy);
        window->close();
        ASSERT_TRUE(waitFor([&] { return !std::filesystem::exists(saved); }));
        EXPECT_FALSE(std::filesystem::exists(older));
        std::filesystem::rename(copy, saved);  // for the next round
    }
}

TEST_F(ProjectWindow, ADamagedFileIsSaidAndLeftAsItIs) {
    const QString damaged = folder.filePath(QStringLiteral("damaged.noonmark.gpkg"));
    const QByteArray half = bytesOf(file).left(5000);
    QFile out(damaged);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(half);
    out.close();
    const auto city = workbench().city();
    window->open({damaged});
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    EXPECT_TRUE(message().contains(QStringLiteral("damaged.noonmark.gpkg"))) << message().toStdString();
    EXPECT_EQ(workbench().city(), city);
    EXPECT_EQ(bytesOf(damaged), half);
}

TEST_F(ProjectWindow, ASaveOverSomeoneElsesIsRefusedAndOffersAnotherName) {
    build();
    auto other = ProjectFile::open(file.toStdString()).value();
    Project theirs = other.project();
    theirs.lots.clear();
    ASSERT_TRUE(other.save(theirs));
    save();
    EXPECT_TRUE(message().contains(QStringLiteral("someone else"))) << message().toStdString();
    EXPECT_TRUE(session().hasUnsavedWork());
    EXPECT_TRUE(ProjectFile::open(file.toStdString()).value().project().lots.empty());
}

TEST_F(ProjectWindow, ComparesTwoScenariosAndKeepsTheResult) {
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    question.period.zone = "America/New_York";
    workbench().document().change(question, QStringLiteral("test"));
    build();
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    // Keeps the object alive, so that no other comparison gets its address.
    const auto held = workbench().comparison();
    const ImpactAnswer& answer = *held;
    EXPECT_EQ(answer.from, existingCity);
    EXPECT_EQ(answer.to, "Proposal A");
    EXPECT_GT(computeFigures(answer.study.total, 0).gross.touchedM2, 0);
    EXPECT_EQ(window->mode().mode(), ViewMode::analysis);
    const auto legend = window->panel().legend().legend();
    ASSERT_TRUE(legend);
    EXPECT_TRUE(legend->change);
    EXPECT_EQ(legend->patches.size(), 1U) << "the tower stands on what was ground";
    workbench().keepAnswer(QStringLiteral("Impact"));
    ASSERT_TRUE(waitFor([this] { return session().project().results.size() == 1; }));
    EXPECT_EQ(session().project().results[0]->kind, "impact");
    session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("height"));
    ASSERT_TRUE(waitFor([&] {
        return workbench().comparison() && workbench().comparison().get() != &answer;
    })) << "a quick result is recomputed after the change";
    session().compareWith({});
    EXPECT_EQ(workbench().comparison(), nullptr);
}

TEST_F(ProjectWindow, AllScenariosAreMeasuredForTheTable) {
    build();
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    workbench().document().change(question, QStringLiteral("test"));
    workbench().measureAll();
    ASSERT_TRUE(waitFor([this] { return workbench().studies().size() == 2; }));
    const auto studies = workbench().studies();
    EXPECT_GT(studies.at("Proposal A")->statistics.shadowAreaM2,
              studies.at(existingCity)->statistics.shadowAreaM2);
    EXPECT_EQ(workbench().study(), studies.at("Proposal A"));
    session().goTo(existingCity);
    ASSERT_TRUE(waitFor([&] { return workbench().study() == studies.at(existingCity); }))
        << "saved and shown again";
}

TEST_F(ProjectWindow, ACityBecomesAProjectOfItsOwn) {
    open(QStringLiteral("sample:central-park-south"));
    EXPECT_FALSE(session().file());
    EXPECT_FALSE(session().hasUnsavedWork());
    EXPECT_GE(session().project().lots.size(), 7U);
    EXPECT_EQ(session().project().regions.size(), 1U);
    const QString name = folder.filePath(QStringLiteral("park.noonmark.gpkg"));
    window->saving().saveTo(name.toStdString());
    ASSERT_TRUE(waitFor([this] { return session().file().has_value(); }));
    EXPECT_EQ(ProjectFile::open(name.toStdString()).value().project().city->buildings.size(),
              session().project().city->buildings.size());
}

TEST_F(ProjectWindow, ASaveThatEndsAfterAnotherWasOpenedIsNotTakenForThatOnes) {
    const QString other = folder.filePath(QStringLiteral("other.noonmark.gpkg"));
    ASSERT_TRUE(ProjectFile::create(other.toStdString(), test::smallProject()));
    build();
    const QSignalSpy saved(&window->saving(), &SavingActions::saved);
    // The save starts just before the other project is taken and ends after it.
    QObject::connect(&workbench().opening(), &JobSlot::ended, window.get(),
                     [this] { window->saving().save(); });
    workbench().open({other});
    ASSERT_TRUE(waitFor([&] { return session().file()->path() == other.toStdString(); }));
    ASSERT_TRUE(waitFor([this] {
        const auto written = ProjectFile::open(file.toStdString());
        return written && written->saves() == 2;
    })) << "the save is still written";
    save();
    EXPECT_EQ(session().file()->path(), other.toStdString());
    EXPECT_EQ(saved.count(), 1) << "of the other";
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ProjectWindow, WhatIsChangedWhileAnotherOpensIsNotLost) {
    window->open({QStringLiteral("sample:grid")});
    ASSERT_TRUE(session().addLot({"Mine", test::square({0, 0}, 10)}));
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    EXPECT_TRUE(message().contains(QStringLiteral("while it was read"))) << message().toStdString();
    EXPECT_EQ(session().file()->path(), file.toStdString());
    EXPECT_EQ(session().project().lots.back().name, "Mine");
}

TEST_F(ProjectWindow, ARunRightAfterAnEditAnswersForTheEditedCity) {
    build();
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    workbench().document().change(question, QStringLiteral("test"));
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("height")));
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy() && !workbench().running().busy(); }));
    EXPECT_TRUE(workbench().study());
    EXPECT_EQ(workbench().studies().count("Proposal A"), 1U);
}

TEST_F(ProjectWindow, ARunningComparisonOutlivesAnotherNameOfEitherSide) {
    build();
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    workbench().document().change(question, QStringLiteral("test"));
    ASSERT_TRUE(session().change(withScenario(session().project(), "Other", {}), QStringLiteral("new")));
    session().compareWith("Other");
    ASSERT_TRUE(workbench().running().busy());
    ASSERT_TRUE(session().rename(ProjectPart::scenario, "Other", "Base"));
    ASSERT_TRUE(session().rename(ProjectPart::scenario, "Proposal A", "Tall"));
    EXPECT_TRUE(workbench().running().busy());
    EXPECT_EQ(session().baseline(), "Base");
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    EXPECT_EQ(workbench().comparison()->from, "Base");
    EXPECT_EQ(workbench().comparison()->to, "Tall");
    workbench().document().undoStack().undo();
    workbench().document().undoStack().undo();
    ASSERT_TRUE(workbench().comparison()) << "undoing the renaming does not end it either";
    EXPECT_EQ(session().baseline(), "Other");
    EXPECT_EQ(workbench().comparison()->from, "Other");
    EXPECT_EQ(workbench().comparison()->to, "Proposal A");
}

TEST_F(ProjectWindow, AStudyOutlivesAnotherNameOfItsScenario) {
    build();
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    workbench().document().change(question, QStringLiteral("test"));
    workbench().run();
    ASSERT_TRUE(session().rename(ProjectPart::scenario, "Proposal A", "Tall"));
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy(); }));
    EXPECT_TRUE(workbench().study());
    EXPECT_EQ(workbench().studies().count("Tall"), 1U);
}

TEST_F(ProjectWindow, OlderUnsavedWorkIsOfferedAndGoesWhenItIsDiscarded) {
    build();
    keepUnsaved();
    kill();
    const auto older = ProjectSaving::olderRecovery(file.toStdString());
    std::filesystem::rename(recovery(), older);
    makeWindow();
    open(file);
    EXPECT_TRUE(message().startsWith(QStringLiteral("There are unsaved changes to small from 2")))
        << message().toStdString();
    takeOffer();
    ASSERT_TRUE(waitFor([this] { return session().project().scenarios.size() == 1; }));
    EXPECT_TRUE(window->close());  // the question is answered by Discard
    EXPECT_FALSE(std::filesystem::exists(older));
}

TEST_F(ProjectWindow, OlderUnsavedWorkIsOfferedBesideNewerAndCanBeDeleted) {
    build();
    keepUnsaved();
    kill();
    const auto older = ProjectSaving::olderRecovery(file.toStdString());
    std::filesystem::copy_file(recovery(), older);
    const auto other = [this] {
        return window->panel().messages().findChild<QPushButton*>(QStringLiteral("otherRemedy"));
    };
    makeWindow();
    open(file);
    EXPECT_TRUE(message().startsWith(QStringLiteral("Noonmark closed before"))) << message().toStdString();
    other()->click();
    EXPECT_TRUE(message().startsWith(QStringLiteral("There are unsaved changes to small from 2")))
        << message().toStdString();
    takeOffer();
    ASSERT_TRUE(waitFor([this] { return session().project().scenarios.size() == 1; }));
    EXPECT_TRUE(window->close());
    EXPECT_FALSE(std::filesystem::exists(older));
    EXPECT_TRUE(std::filesystem::exists(recovery())) << "the newer one was not recovered";
    std::filesystem::copy_file(recovery(), older);
    kill();
    makeWindow();
    open(file);
    other()->click();
    other()->click();
    EXPECT_FALSE(std::filesystem::exists(older)) << "deleted";
    EXPECT_TRUE(std::filesystem::exists(recovery()));
}

TEST_F(ProjectWindow, ADrawnRegionGoesIntoTheProjectInOneStepOfUndo) {
    const StudySettings before = workbench().document().settings();
    PolygonTool& tool = window->panel().regionTool();
    tool.begin();
    for (const glm::dvec3 corner : {glm::dvec3{0, 0, 0}, {100, 0, 0}, {100, 80, 0}}) tool.addPoint(corner);
    tool.finish();
    ASSERT_EQ(session().project().regions.size(), 2U);
    const Region drawn = session().project().regions[1];
    EXPECT_EQ(drawn.name, "Region");
    EXPECT_EQ(bounds(drawn), (Box2{{0, 0}, {100, 80}}));
    EXPECT_EQ(workbench().document().settings().region, drawn);
    EXPECT_TRUE(session().hasUnsavedWork());
    workbench().document().undoStack().undo();
    EXPECT_EQ(session().project().regions.size(), 1U);
    EXPECT_EQ(workbench().document().settings(), before);
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ProjectWindow, ADrawnRegionOfACityWithoutAFileIsUnsavedWork) {
    open(QStringLiteral("sample:grid"));
    PolygonTool& tool = window->panel().regionTool();
    tool.begin();
    for (const glm::dvec3 corner : {glm::dvec3{0, 0, 0}, {100, 0, 0}, {100, 80, 0}}) tool.addPoint(corner);
    tool.finish();
    EXPECT_TRUE(session().hasUnsavedWork());
    workbench().document().undoStack().undo();
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ProjectWindow, AQuickComparisonIsThereAgainWhenTheProjectIsReopenedAndASlowOneIsNamed) {
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    question.period.zone = "America/New_York";
    workbench().document().change(question, QStringLiteral("test"));
    build();
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    save();
    makeWindow();
    open(file);
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    EXPECT_EQ(workbench().comparison()->to, "Proposal A");
    auto saved = ProjectFile::open(file.toStdString()).value();
    Project slow = saved.project();
    slow.view["answer_seconds"] = "4000";
    ASSERT_TRUE(saved.save(slow));
    makeWindow();
    open(file);
    EXPECT_FALSE(workbench().running().busy());
    const QString note = window->findChild<QLabel*>(QStringLiteral("resultNote"))->text();
    EXPECT_TRUE(note.startsWith(QStringLiteral("Proposal A was compared with Existing when")))
        << note.toStdString();
    EXPECT_TRUE(note.contains(QStringLiteral("about 67 min"))) << note.toStdString();
}

TEST_F(ProjectWindow, IsNoLargerThanTheScreenAlsoWhereThatShowsHalfAsMuchAgain) {
    QSettings fresh(folder.filePath(QStringLiteral("fresh.ini")), QSettings::IniFormat);
    fresh.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("other")));
    const MainWindow first(fresh);
    const QSize screen = first.screen()->availableGeometry().size();
    EXPECT_LE(first.width(), screen.width());
    EXPECT_LE(first.height(), screen.height());
    // 1280 x 1024 at 150 %.
    EXPECT_LE(first.minimumSizeHint().width(), 853);
    EXPECT_LE(first.minimumSizeHint().height(), 682);
}

TEST_F(ProjectWindow, ATipOfTheStatusBarNeverLiesOverTheCoordinates) {
    const auto* hover = window->findChild<QLabel*>(QStringLiteral("hover"));
    EXPECT_TRUE(hover->isVisible());
    window->hide();
    window->statusBar()->showMessage(QStringLiteral("a tip"));
    window->show();
    EXPECT_FALSE(hover->isVisible());
    window->statusBar()->clearMessage();
    EXPECT_TRUE(hover->isVisible());
}

TEST_F(ProjectWindow, AWarningLeadsToItsBuilding) {
    auto* dock = window->findChild<WarningsDock*>();
    const std::string id = test::idOf(session().project(), 2);
    dock->show({{WarningKind::assumed, "no height in the data", "small.geojson: " + id + ", height"},
                {WarningKind::dropped, "no area", "way 7"}});
    Q_EMIT dock->itemActivated(dock->topLevelItem(0)->child(0), 0);
    EXPECT_EQ(window->tools().building().selected(), 2U);
    const glm::dvec3 target = window->panel().view().pose().target;
    EXPECT_NEAR(target.x, -87.5, 30);
    EXPECT_NEAR(target.y, 42.5, 30);
    Q_EMIT dock->itemActivated(dock->topLevelItem(1)->child(0), 0);
    EXPECT_TRUE(message().contains(QStringLiteral("way 7 is not a building"))) << message().toStdString();
}

TEST(WarningPlaces, NameABuildingByItsWholeIdOrAPartsAndTheLongestWins) {
    City city;
    for (const char* id : {"way 12", "way 123", "relation 5", ""}) {
        Building building;
        building.sourceId = id;
        building.parts.push_back({.sourceId = std::string(id).empty() ? "way 77" : ""});
        city.buildings.push_back(std::make_shared<const Building>(building));
    }
    EXPECT_EQ(buildingNamed(city, "way 123"), 1U);
    EXPECT_EQ(buildingNamed(city, "x.osm: way 12, height"), 0U);
    EXPECT_EQ(buildingNamed(city, "way 12 of relation 5"), 2U);
    EXPECT_EQ(buildingNamed(city, "way 77"), 3U);
    EXPECT_EQ(buildingNamed(city, "way 1234"), std::nullopt);
    EXPECT_EQ(buildingNamed(city, ""), std::nullopt);
}

TEST(RecoveryStores, WhatManyRunsLeftDoesNotGrowForEver) {
    const QTemporaryDir folder;
    const auto recovery = recoveryPath(folder.filePath("Untitled 1.noonmark.gpkg").toStdString());
    const int runs = RecoveryStore::mostLeft + 3;
    for (int i = 0; i < runs; ++i) {
        QFile file(QString::fromStdString(recovery.string()));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::number(i));
        file.close();
        const RecoveryStore place(folder.path());
        EXPECT_EQ(bytesOf(QString::fromStdString(place.left().value().string())), QByteArray::number(i));
    }
    for (int i = runs - 1; i >= runs - RecoveryStore::mostLeft; --i) {
        RecoveryStore place(folder.path());
        EXPECT_EQ(bytesOf(QString::fromStdString(place.left().value().string())), QByteArray::number(i));
        place.forgetLeft();
    }
    EXPECT_FALSE(RecoveryStore(folder.path()).left());
}

TEST(RecoveryStores, WhatTwoRunsLeftIsKeptTheNewestFirst) {
    const QTemporaryDir folder;
    const auto recovery = recoveryPath(folder.filePath("Untitled 1.noonmark.gpkg").toStdString());
    const auto leave = [&](const char* text) {
        QFile file(QString::fromStdString(recovery.string()));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    const auto left = [](const RecoveryStore& place) {
        return bytesOf(QString::fromStdString(place.left().value().string()));
    };
    leave("first");
    EXPECT_EQ(left(RecoveryStore(folder.path())), "first");
    leave("second");
    {
        RecoveryStore place(folder.path());
        EXPECT_EQ(left(place), "second");
        place.forgetLeft();
    }
    EXPECT_EQ(left(RecoveryStore(folder.path())), "first");
}

}  // namespace
}  // namespace noonmark
