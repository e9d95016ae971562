#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <set>
#include <string>

#include "app/gui/frame/help/start_page.h"
#include "app/gui/frame/tour/tour.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::waitFor;

constexpr int limitMs = 240000;  // of a step that computes, far above the time needed

struct TourWindow : test::ProjectWindow {
    Tour* begin(std::size_t tour) {
        window->tours().start(tour);
        EXPECT_TRUE(waitFor([&] { return window->tours().running() != nullptr; })) << message().toStdString();
        return window->tours().running();
    }
    TourBubble* bubble() { return window->findChild<TourBubble*>(); }
    QString text() { return bubble()->findChild<QLabel*>(QStringLiteral("tourText"))->text(); }
    void press(const char* name) { bubble()->findChild<QPushButton*>(QLatin1String(name))->click(); }

    // Presses "Show me" in every step, and expects the next one to follow.
    void walk(std::size_t index) {
        Tour* tour = begin(index);
        ASSERT_NE(tour, nullptr);
        std::set<QString> texts;
        while (tour->step() + 1 < tour->steps()) {
            const std::size_t step = tour->step();
            texts.insert(text());
            const char* control = listTours()[index].steps[step].control;
            press("tourShowMe");
            ASSERT_TRUE(waitFor([&] { return tour->step() > step; }, limitMs))
                << listTours()[index].key << ", step " << step << ": " << control << "; "
                << message().toStdString();
            EXPECT_EQ(tour->step(), step + 1) << "no step is skipped after " << control;
        }
        EXPECT_EQ(texts.size() + 1, tour->steps()) << "each step has a text of its own";
        press("tourEnd");
        EXPECT_EQ(window->tours().running(), nullptr);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        EXPECT_EQ(bubble(), nullptr);
    }
};

TEST_F(TourWindow, TheArchitectsTourEndsWithAComparison) {
    walk(0);
    ASSERT_TRUE(workbench().answerAs<ImpactAnswer>());
    EXPECT_GT(computeFigures(workbench().answerAs<ImpactAnswer>()->study.total).gross.moreShadowM2, 0)
        << "the tower throws a shadow";
}

TEST_F(TourWindow, ThePlannersTourEndsWithAScoreOfAYear) {
    walk(1);
    ASSERT_TRUE(workbench().answerAs<ScoreAnswer>());
    EXPECT_EQ(workbench().document().settings().period.days, 365);
}

TEST_F(TourWindow, TheReviewBoardsTourEndsWithVerdicts) {
    walk(2);
    ASSERT_TRUE(window->review().shown());
    const auto& places = window->review().shown()->study.places;
    ASSERT_EQ(places.size(), 2U) << "Central Park of the sample, and the park of the tour";
    EXPECT_GT(places.back().totals.incrementalM2h, 0) << "the shadow reaches it";
}

TEST_F(TourWindow, AStepIsDoneWhenTheUserDoesIt) {
    Tour* tour = begin(1);
    window->findChild<QPushButton*>(QStringLiteral("run"))->click();
    QCoreApplication::processEvents();
    EXPECT_EQ(tour->step(), 0U) << "the control of another step";
    auto* kind = window->findChild<QComboBox*>(QStringLiteral("studyKind"));
    Q_EMIT kind->activated(1);
    QCoreApplication::processEvents();
    EXPECT_EQ(tour->step(), 0U) << "another entry";
    Q_EMIT kind->activated(0);
    EXPECT_TRUE(waitFor([&] { return tour->step() == 1; }));
    press("tourEnd");
    EXPECT_EQ(window->tours().running(), nullptr);
}

TEST_F(TourWindow, ADockBehindOthersIsShownByItsTab) {
    auto* tower = window->findChild<QDockWidget*>(QStringLiteral("towerDock"));
    window->findChild<QDockWidget*>(QStringLiteral("studyDock"))->raise();
    QCoreApplication::processEvents();
    const TourControl control(*window, listTours()[0].steps[0], [] {});
    const QRect tab = control.area();
    EXPECT_TRUE(window->rect().contains(tab)) << "the dock itself lies outside of the window";
    EXPECT_LT(tab.height(), 60);
    tower->raise();
    EXPECT_TRUE(waitFor([&] { return control.area().height() > 60; })) << "the dock in front";
}

TEST_F(TourWindow, EveryControlIsFoundAndEveryTourIsOnTheStartPage) {
    for (const TourPlan& plan : listTours())
        for (const TourStep& step : plan.steps)
            EXPECT_TRUE(TourControl(*window, step, [] {}).found()) << plan.key << ": " << step.control;
    EXPECT_EQ(listTours().size(), 3U) << "one for each user";
    EXPECT_EQ(window->tours().actions().size(), 3);
    const StartPage start(RecentFiles(settings), true, *window, window->panel());
    EXPECT_EQ(start.findChildren<QPushButton*>(QStringLiteral("startTour")).size(), 3);
}

}  // namespace
}  // namespace noonmark
