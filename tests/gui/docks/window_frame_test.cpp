#include <gtest/gtest.h>

#include <QAccessible>
#include <QDockWidget>
#include <QLabel>
#include <QScreen>
#include <QSet>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTest>

#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/review/review_form.h"
#include "app/gui/docks/study_form/element_form.h"
#include "app/gui/frame/actions/edit_actions.h"
#include "app/gui/frame/window_layout.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;

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

TEST_F(ProjectWindow, APanelSideCollapsesAndComesBackAsItWas) {
    const auto shown = [this] {
        QStringList names;
        for (const QDockWidget* dock : window->findChildren<QDockWidget*>())
            if (!dock->isHidden()) names << dock->objectName();
        names.sort();  // the window orders its children anew when they are shown
        return names;
    };
    window->findChild<QDockWidget*>(QStringLiteral("scenariosDock"))->show();
    const QStringList before = shown();
    auto* side = window->findChild<QAction*>(QStringLiteral("side%1").arg(int(Qt::LeftDockWidgetArea)));
    ASSERT_NE(side, nullptr);
    side->trigger();
    EXPECT_FALSE(shown().contains(QStringLiteral("studyDock")));
    EXPECT_FALSE(shown().contains(QStringLiteral("projectDock")));
    EXPECT_TRUE(shown().contains(QStringLiteral("scenariosDock"))) << "the other side stays";
    side->trigger();
    EXPECT_EQ(shown(), before);
}

TEST_F(ProjectWindow, TheViewHasHalfOfASmallScreenUntilThereIsAnAnswer) {
    window->resize(1366, 740);
    QCoreApplication::processEvents();
    const auto share = [this] {
        const CityView& view = window->panel().view();
        return double(view.width()) * view.height() / (double(window->width()) * window->height());
    };
    EXPECT_TRUE(window->findChild<QDockWidget*>(QStringLiteral("resultsDock"))->isHidden());
    EXPECT_TRUE(waitFor([&] { return share() >= 0.5; })) << share();
    window->panel().messages().showHelp(QStringLiteral("A message"));
    QCoreApplication::processEvents();
    EXPECT_GE(share(), 0.5) << "a message lies over the view";
    QTest::mouseClick(&window->panel().messages(), Qt::LeftButton, {}, QPoint(3, 3));
    EXPECT_EQ(window->panel().messages().text(), QString()) << "a click closes it";
}

TEST_F(ProjectWindow, AReviewLeavesASmallScreenToTheViewAndDoesNotWidenTheWindow) {
    const QSize screen(1366, 740);
    window->resize(screen);
    auto* results = window->findChild<QDockWidget*>(QStringLiteral("resultsDock"));
    openDock(*window, *results);
    QCoreApplication::processEvents();
    EXPECT_FALSE(results->isHidden());
    EXPECT_GE(window->panel().width(), window->width() / 2 - 20) << "beside an answer";
    window->mode().setMode(ViewMode::review);
    QCoreApplication::processEvents();
    EXPECT_TRUE(results->isHidden()) << "three sides leave no room";
    ReviewChoice choice = window->review().choice();
    choice.rule = "en-17037";
    window->review().choose(choice);
    ElementForm& form = window->findChild<ReviewForm*>()->elements();
    ASSERT_TRUE(waitFor([&] { return form.isVisible(); }));
    QCoreApplication::processEvents();
    EXPECT_EQ(window->size(), screen) << "a long form scrolls";
    window->findChild<QAction*>(QStringLiteral("side%1").arg(int(Qt::RightDockWidgetArea)))->trigger();
    EXPECT_FALSE(results->isHidden()) << "its key brings it back";
}

// 2560 x 1440 at 150 %.
TEST_F(ProjectWindow, VerdictsBelowTheViewLeaveItHalfOfTheHeight) {
    window->resize(1706, 937);
    window->mode().setMode(ViewMode::review);
    auto* verdicts = window->findChild<QDockWidget*>(QStringLiteral("reviewDock"));
    ASSERT_TRUE(waitFor([&] { return verdicts->isVisible(); }));
    EXPECT_TRUE(waitFor([this] { return window->panel().view().height() >= 0.47 * window->height(); }))
        << window->panel().view().height();
}

TEST_F(ProjectWindow, ScreenReadersHaveANameForEverythingThatTakesTheKeyboard) {
    QStringList silent;
    for (QWidget* widget : window->findChildren<QWidget*>()) {
        if (widget->focusPolicy() == Qt::NoFocus) continue;
        const auto* tabs = qobject_cast<QTabBar*>(widget);
        if (tabs && tabs->count() == 0) continue;  // a spare one, which is never shown; tabs name themselves
        QAccessibleInterface* output = QAccessible::queryAccessibleInterface(widget);
        if (output == nullptr || output->text(QAccessible::Name).isEmpty())
            silent << QStringLiteral("%1 '%2'").arg(QLatin1String(widget->metaObject()->className()),
                                                    widget->objectName());
    }
    EXPECT_EQ(silent.join(u'\n').toStdString(), "");
}

TEST_F(ProjectWindow, TabGoesThroughAllFieldsOfADockAndBackToTheFirst) {
    QSet<const QWidget*> reached;
    const QWidget* at = &window->panel();
    do {
        reached << at;
        at = at->nextInFocusChain();
    } while (at != &window->panel() && reached.size() < 20000);
    for (const QWidget* widget : window->findChildren<QWidget*>()) {
        const bool isReachedByTab =
            (widget->focusPolicy() & Qt::TabFocus) && widget->window() == window.get();
        EXPECT_TRUE(!isReachedByTab || reached.contains(widget)) << widget->objectName().toStdString();
    }
}

}  // namespace
}  // namespace noonmark
