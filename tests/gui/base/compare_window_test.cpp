#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QMouseEvent>
#include <QTest>
#include <QTimer>
#include <utility>

#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/view/compare/compare_actions.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::waitFor;

/// The small project with a tower, compared with the existing city in the view.
struct CompareWindow : test::ProjectWindow {
    void SetUp() override {
        ProjectWindow::SetUp();
        window->resize(1400, 900);
        build();
    }

    CityView& view() { return window->panel().view(); }
    QAction& way(const char* name) {
        return *window->comparing().findChild<QAction*>(QString::fromLatin1(name));
    }
    QComboBox& others() { return *window->findChild<QComboBox*>(QStringLiteral("compareOther")); }
    QString note() { return strip().findChild<QLabel*>(QStringLiteral("compareNote"))->text(); }
    CompareStrip& strip() { return *window->findChild<CompareStrip*>(); }

    void show(const char* name) {
        way(name).trigger();
        ASSERT_TRUE(waitFor([this] { return view().sides().layout != SideLayout::one; }))
            << message().toStdString();
    }

    // Frames lag behind the scene, and names come when the camera rests.
    // A picture that stays: on a busy machine two in a row may be equal before a new one begins.
    // A strip of a running job takes room from the view.
    bool isBusy() const {
        return std::ranges::any_of(window->findChildren<ProgressStrip*>(), &ProgressStrip::isVisible);
    }

    QImage captured() {
        QImage before, now = take();
        int equal = 0;
        EXPECT_TRUE(waitFor([&] {
            QTest::qWait(50);
            before = std::exchange(now, take());
            equal = before == now && !isBusy() ? equal + 1 : 0;
            return equal == 6;
        }));
        return now;
    }

    // Once the strip of a job that has ended has given its room back to the view.
    QImage capturedAt(QSize size) {
        EXPECT_TRUE(waitFor([&] { return take().size() == size; }));
        return captured();
    }

    QImage take() {
        QImage image;
        view().capture([&image](const QImage& made) { image = made; });
        EXPECT_TRUE(waitFor([&image] { return !image.isNull(); }));
        return image;
    }

    static int differing(const QImage& a, const QImage& b, int fromX, int toX) {
        int count = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = fromX; x < toX; ++x)
                count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 12 ? 1 : 0;
        return count;
    }

    void lookAtTower() { window->panel().navigator().showSlanting({{-30, -40}, {90, 80}}); }
};

TEST_F(CompareWindow, TheOtherScenarioIsTheExistingCityUntilAnotherIsChosen) {
    show("compareSwipe");
    EXPECT_TRUE(strip().isVisible());
    EXPECT_EQ(others().currentText().toStdString(), existingCity);
    EXPECT_EQ(view().sides(), (ViewSides{SideLayout::swipe, 0.5}));
    way("compareSwipe").trigger();
    EXPECT_EQ(view().sides().layout, SideLayout::one);
    EXPECT_FALSE(strip().isVisible());
}

TEST_F(CompareWindow, OnlyOneWayIsChosen) {
    show("compareSwipe");
    show("compareBeside");
    EXPECT_FALSE(way("compareSwipe").isChecked());
    EXPECT_EQ(view().sides().layout, SideLayout::beside);
    way("compareFlicker").trigger();
    EXPECT_EQ(view().sides(), (ViewSides{SideLayout::swipe, 1}));
    way("compareFlicker").trigger();
    EXPECT_EQ(view().sides().layout, SideLayout::one);
}

TEST_F(CompareWindow, EachOfTwoSidesShowsAllThatWasInSightAndTheCameraReturns) {
    const CameraPose before = view().pose();
    const auto widthM = [this] {
        return metresPerPixel(view().pose(), view().lens()) * view().lens().widthPx;
    };
    const double seenM = widthM();
    show("compareBeside");
    EXPECT_GE(widthM(), 0.99 * seenM);
    EXPECT_LE(widthM(), 1.06 * seenM) << "the strip above takes some of the height";
    way("compareBeside").trigger();
    EXPECT_EQ(view().pose(), before);
    show("compareBeside");
    CameraPose moved = view().pose();
    moved.headingDeg += 30;
    view().setPose(moved);
    way("compareBeside").trigger();
    EXPECT_EQ(view().pose(), moved) << "it was moved meanwhile";
}

// The tower is in the middle of the picture.
TEST_F(CompareWindow, ASwipeShowsTheOtherScenarioToTheLeftOfItsDivider) {
    window->mode().setMode(ViewMode::analysis);  // without a study nothing is computed meanwhile
    show("compareSwipe");
    lookAtTower();
    const auto dividedAt = [this](double share) {
        view().setSides({SideLayout::swipe, share});
        return captured();
    };
    const QImage with = dividedAt(0), without = dividedAt(1), swiped = dividedAt(0.5);
    const int middle = with.width() / 2, border = 8;
    ASSERT_GT(differing(with, without, 0, middle - border), 500);
    ASSERT_GT(differing(with, without, middle + border, with.width()), 500);
    EXPECT_EQ(differing(swiped, without, border, middle - border), 0);
    EXPECT_EQ(differing(swiped, with, middle + border, with.width() - border), 0);
}

// What is edited belongs to the displayed scenario.
TEST_F(CompareWindow, FloorsAndProposalsAreDrawnOnTheSideOfTheDisplayedScenario) {
    window->mode().setMode(ViewMode::analysis);
    show("compareSwipe");
    lookAtTower();
    const auto drawnWith = [this](double share, bool floors) {
        view().setSides({SideLayout::swipe, share});
        view().overlay().showFloors(floors ? std::vector<std::vector<glm::vec3>>{{{10, -5, 30},
                                                                                  {50, -5, 30},
                                                                                  {50, -5, 40},
                                                                                  {10, -5, 40}}}
                                           : std::vector<std::vector<glm::vec3>>{});
        return captured();
    };
    const QImage other = drawnWith(1, false), otherFloors = drawnWith(1, true);
    EXPECT_EQ(differing(other, otherFloors, 0, other.width()), 0);
    const QImage displayed = drawnWith(0, false), displayedFloors = drawnWith(0, true);
    EXPECT_GT(differing(displayed, displayedFloors, 0, displayed.width()), 20);
}

TEST_F(CompareWindow, TheDividerIsDragged) {
    show("compareSwipe");
    const double width = view().width();
    const auto send = [&](QEvent::Type type, double x, Qt::MouseButtons buttons) {
        QMouseEvent event(type, QPointF(x, 100), QPointF(x, 100), Qt::LeftButton, buttons, Qt::NoModifier);
        QCoreApplication::sendEvent(&view(), &event);
    };
    const CameraPose before = view().pose();
    send(QEvent::MouseButtonPress, width / 2 + 3, Qt::LeftButton);
    send(QEvent::MouseMove, width / 4, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, width / 4, Qt::NoButton);
    EXPECT_NEAR(view().sides().divider, 0.25, 0.01);
    EXPECT_EQ(view().pose(), before) << "the camera stays";
}

// Beside each other, a pixel of either picture shows the same place.
TEST_F(CompareWindow, PicturesBesideEachOtherShareTheCamera) {
    show("compareBeside");
    EXPECT_EQ(view().lens().widthPx, view().width() / 2);
    const double half = view().width() / 2.0;
    EXPECT_EQ(view().sideOffset({10, 10}), 0);
    EXPECT_EQ(view().sideOffset({half + 10, 10}), half);
    QPointF hovered;
    QObject::connect(&window->panel().navigator(), &ViewNavigator::hovered, &view(),
                     [&hovered](QPointF pixel) { hovered = pixel; });
    QMouseEvent event(QEvent::MouseMove, QPointF(half + 40, 50), QPointF(half + 40, 50), Qt::NoButton,
                      Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view(), &event);
    EXPECT_EQ(hovered, QPointF(40, 50));
}

TEST_F(CompareWindow, TheStudyOfTheOtherScenarioIsShownInTheSameColours) {
    lookAtTower();
    show("compareSwipe");
    window->mode().setMode(ViewMode::analysis);
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().study() != nullptr; }, 20000)) << message().toStdString();
    QCoreApplication::processEvents();  // the panel of results has opened
    const QSize calm = captured().size();
    EXPECT_TRUE(note().contains(QStringLiteral("not measured yet"))) << note().toStdString();
    const QImage before = capturedAt(calm);
    workbench().measureAll();
    ASSERT_TRUE(waitFor([this] { return workbench().measuredScenarios().size() == 2; }, 20000));
    EXPECT_EQ(note(), QStringLiteral("the same question, in the same colours"));
    const QImage after = capturedAt(calm);
    EXPECT_GT(differing(before, after, 0, after.width() / 2 - 8), 500);
    EXPECT_EQ(differing(before, after, after.width() / 2 + 8, after.width()), 0);
}

// The city was measured before the tower was built: its colours are those of the city.
TEST_F(CompareWindow, WhatWasMeasuredBeforeATowerWasBuiltIsShownOfTheCityOnly) {
    window->mode().setMode(ViewMode::analysis);
    session().goTo(existingCity);
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().study() != nullptr; }, 20000)) << message().toStdString();
    const std::string tower = session().project().scenarios.front().name;
    QObject::connect(&workbench().running(), &JobSlot::started, window.get(),  // as a long run does not begin
                     [this] { QTimer::singleShot(0, [this] { workbench().running().drop(); }); });
    session().goTo(tower);
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    show("compareSwipe");
    EXPECT_EQ(others().currentText().toStdString(), existingCity);
    EXPECT_EQ(window->panel().results().missingSides(), std::vector<std::string>{tower});
    EXPECT_EQ(note(), QStringLiteral("not measured yet: %1 (Scenario > Measure all scenarios)")
                          .arg(QString::fromStdString(tower)));
    EXPECT_TRUE(window->panel().legend().legend()) << "of the city's colours";
}

TEST_F(CompareWindow, AComparisonShowsTheShadowOfBothScenarios) {
    lookAtTower();
    window->mode().setMode(ViewMode::analysis);
    session().setBaseline(existingCity);
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }, 20000))
        << message().toStdString();
    const QString change = window->panel().legend().legend()->title;
    show("compareSwipe");
    EXPECT_EQ(note(), QStringLiteral("the same question, in the same colours"));
    EXPECT_TRUE(window->panel().results().missingSides().empty());
    EXPECT_NE(window->panel().legend().legend()->title, change) << "minutes of each";
    way("compareSwipe").trigger();
    EXPECT_EQ(window->panel().legend().legend()->title, change);
}

TEST_F(CompareWindow, AStudyWithOtherSettingsIsNotTheSame) {
    show("compareSwipe");
    window->mode().setMode(ViewMode::analysis);
    workbench().measureAll();
    ASSERT_TRUE(waitFor([this] { return workbench().measuredScenarios().size() == 2; }, 20000));
    StudySettings settings = workbench().document().settings();
    settings.period.hours = 3;
    workbench().document().change(settings, QStringLiteral("hours"));
    workbench().run();
    ASSERT_TRUE(waitFor([&] { return workbench().study()->settings == settings; }, 20000));
    EXPECT_TRUE(note().contains(QStringLiteral("not measured yet"))) << note().toStdString();
}

TEST_F(CompareWindow, TheOtherScenarioFollowsItsNameAndGivesWayWhenItIsGone) {
    session().goTo(existingCity);
    show("compareSwipe");
    const std::string tower = session().project().scenarios.front().name;
    EXPECT_EQ(others().currentText().toStdString(), tower);
    ASSERT_TRUE(session().rename(ProjectPart::scenario, tower, "Renamed"));
    EXPECT_EQ(window->comparing().other().name(), "Renamed");
    EXPECT_EQ(others().currentText(), QStringLiteral("Renamed"));
    Project without = session().project();
    without.scenarios.clear();
    ASSERT_TRUE(session().change(std::move(without), QStringLiteral("none")));
    EXPECT_EQ(view().sides().layout, SideLayout::one);
}

TEST_F(CompareWindow, EndsWithTheScenarioAndSaysSoWithOne) {
    show("compareSwipe");
    window->workbench().document().undoStack().undo();  // the tower, and with it the only scenario
    ASSERT_TRUE(waitFor([this] { return view().sides().layout == SideLayout::one; }));
    way("compareSwipe").trigger();
    EXPECT_FALSE(way("compareSwipe").isChecked());
    EXPECT_TRUE(message().contains(QStringLiteral("only one scenario"))) << message().toStdString();
}

TEST(ViewSides, ColumnsAreDividedWithoutAGap) {
    EXPECT_EQ(columnsOf({}, 0, 101).last, 101);
    EXPECT_EQ(columnsOf({}, 1, 101).last, 0);
    const ViewSides swipe{SideLayout::swipe, 0.3};
    EXPECT_EQ(columnsOf(swipe, 1, 101).first, 0);
    EXPECT_EQ(columnsOf(swipe, 1, 101).last, 30);
    EXPECT_EQ(columnsOf(swipe, 0, 101).first, 30);
    EXPECT_EQ(columnsOf(swipe, 0, 101).last, 101);
}

}  // namespace
}  // namespace noonmark
