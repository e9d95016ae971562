#include "app/gui/frame/window_renewal.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QUndoStack>

#include "app/gui/base/looks/language.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/length_field.h"
#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/small_project.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

struct RenewalTest : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    std::unique_ptr<WindowRenewal> renewal;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        const QString file = folder.filePath(QStringLiteral("small.noonmark.gpkg"));
        ASSERT_TRUE(ProjectFile::create(file.toStdString(), test::smallProject()));
        renewal = std::make_unique<WindowRenewal>(settings);
        window().resize(1000, 700);
        window().show();
        window().open({file});
        ASSERT_TRUE(waitFor([this] { return window().workbench().city() != nullptr; }));
    }
    void TearDown() override {
        renewal.reset();
        applyLanguage(Language::english, *qApp);
        applyUnits(UnitSystem::metric);
    }
    MainWindow& window() { return renewal->window(); }
    void choose(Language language, UnitSystem units) {
        saveLanguage(language, settings);
        saveUnits(units, settings);
        QSignalSpy renewed(renewal.get(), &WindowRenewal::renewed);
        Q_EMIT window().textsChanged();
        ASSERT_TRUE(waitFor([&] { return renewed.size() == 1; }));
    }
};

TEST_F(RenewalTest, AnotherLanguageAndOtherUnitsHoldAtOnceForAllTexts) {
    choose(Language::german, UnitSystem::imperial);
    EXPECT_EQ(window().findChild<QDockWidget*>(QStringLiteral("studyDock"))->windowTitle(),
              QCoreApplication::translate("QObject", "Study"));
    EXPECT_NE(QCoreApplication::translate("QObject", "Results"), QStringLiteral("Results"));
    EXPECT_EQ(window().findChild<QDockWidget*>(QStringLiteral("resultsDock"))->windowTitle(),
              QCoreApplication::translate("QObject", "Results"));
    const auto fields = window().findChildren<LengthField*>();
    ASSERT_FALSE(fields.isEmpty());
    EXPECT_TRUE(fields[0]->textFromValue(10).contains(u'\'')) << fields[0]->textFromValue(10).toStdString();
}

TEST_F(RenewalTest, TheWorkStaysWithItsUndoAndItsView) {
    ASSERT_TRUE(
        window().workbench().session().addEdits({test::newTower("New", 70)}, QStringLiteral("tower")));
    ASSERT_TRUE(waitFor([this] { return window().workbench().city()->city().buildings.size() == 4; }));
    CameraPose pose = window().panel().view().pose();
    pose.headingDeg = 77;
    window().panel().view().setPose(pose);
    window().mode().setMode(ViewMode::analysis);
    window().findChild<QDockWidget*>(QStringLiteral("projectDock"))->hide();
    const QPointer<MainWindow> before = &window();
    const Workbench* work = &window().workbench();
    choose(Language::spanish, UnitSystem::metric);
    EXPECT_TRUE(before.isNull());
    EXPECT_EQ(&window().workbench(), work);
    EXPECT_NEAR(window().panel().view().pose().headingDeg, 77, 1e-6);
    EXPECT_EQ(window().mode().mode(), ViewMode::analysis);
    EXPECT_TRUE(window().findChild<QDockWidget*>(QStringLiteral("projectDock"))->isHidden());
    EXPECT_TRUE(window().isWindowModified()) << "unsaved as before";
    window().workbench().document().undoStack().undo();
    EXPECT_TRUE(waitFor([this] { return window().workbench().city()->city().buildings.size() == 3; }));
}

TEST_F(RenewalTest, AResultStaysShown) {
    window().workbench().run();
    ASSERT_TRUE(waitFor([this] { return window().workbench().answer() != nullptr; }));
    choose(Language::german, UnitSystem::metric);
    EXPECT_TRUE(window().workbench().answer());
    EXPECT_TRUE(window().panel().results().showsStudy() || window().mode().mode() == ViewMode::exploration);
}

}  // namespace
}  // namespace noonmark
