#include <gtest/gtest.h>

#include <QWindow>
#include <chrono>
#include <thread>

#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;
using test::waitFor;

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
    writeRecovery();
    int asked = 0;
    window->saving().setUnsavedQuestion([&] { return ++asked, SavingActions::Unsaved::discard; });
    EXPECT_TRUE(window->close());
    EXPECT_FALSE(window->isVisible());
    EXPECT_EQ(asked, 1);
    // A write that still runs removes its file itself.
    EXPECT_TRUE(waitFor([this] { return !std::filesystem::exists(recovery()); }));
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
        writeRecovery();
        EXPECT_TRUE(std::filesystem::exists(recovery()));
    }
    answer = SavingActions::Unsaved::discard;
    EXPECT_TRUE(window->close());
    EXPECT_FALSE(window->isVisible());
}

TEST_F(ProjectWindow, AQuitAsksBeforeItStopsWhatTheUserWaitsFor) {
    int asked = 0;
    SavingActions::Unsaved answer = SavingActions::Unsaved::cancel;
    window->saving().setUnsavedQuestion([&] { return ++asked, answer; });
    workbench().running().start<int>(
        QStringLiteral("Study"),
        [](Progress&, const std::stop_token& stop) -> Result<int> {
            while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return cancelled();
        },
        [](const Result<int>&) {});
    ASSERT_FALSE(session().hasUnsavedWork());
    EXPECT_FALSE(window->close());
    EXPECT_EQ(asked, 1);
    EXPECT_TRUE(workbench().running().busy()) << "it goes on";
    answer = SavingActions::Unsaved::discard;
    EXPECT_TRUE(window->close());
}

TEST_F(ProjectWindow, AQuitWhoseSaveFailsStaysOpenAndAsksAgain) {
    build();
    writeRecovery();
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
    writeRecovery();
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

TEST_F(ProjectWindow, AMessageAfterTheWindowIsClosedOpensNoWindow) {
    window->panel().messages().showHelp(QStringLiteral("Open"));
    QCoreApplication::processEvents();
    ASSERT_TRUE(window->panel().messages().windowHandle());
    ASSERT_TRUE(window->close());
    QCoreApplication::processEvents();
    ASSERT_FALSE(window->panel().messages().windowHandle()->handle());
    window->panel().messages().showHelp(QStringLiteral("Closed"));
    QCoreApplication::processEvents();
    window->resize(800, 500);
    QCoreApplication::processEvents();
    EXPECT_FALSE(window->panel().messages().windowHandle()->handle());
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

TEST_F(ProjectWindow, WhatIsChangedWhileAnotherOpensIsNotLost) {
    window->open({QStringLiteral("sample:grid")});
    ASSERT_TRUE(session().addLot({"Mine", test::square({0, 0}, 10)}));
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    EXPECT_TRUE(message().contains(QStringLiteral("while it was read"))) << message().toStdString();
    EXPECT_EQ(session().file()->path(), file.toStdString());
    EXPECT_EQ(session().project().lots.back().name, "Mine");
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

}  // namespace
}  // namespace noonmark
