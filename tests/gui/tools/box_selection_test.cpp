#include "app/gui/tools/editing/box_selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>

#include "app/gui/base/widgets/number_text.h"
#include "app/gui/tools/editing/selection_panel.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;
using test::waitFor;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr Qt::KeyboardModifiers boxKeys = Qt::ControlModifier | Qt::ShiftModifier;

/// The window with the small city seen from above: 0 South House, 1 Low House, 2 Tower.
struct GroupWindow : ProjectWindow {
    void SetUp() override {
        ProjectWindow::SetUp();
        window->panel().navigator().go({{0, 0, 0}, 700, 0, 90});
    }
    CityView& view() { return window->panel().view(); }
    BuildingEditing& building() { return window->tools().building(); }
    [[nodiscard]] const City& city() { return workbench().city()->city(); }

    QPointF pixelAt(glm::dvec3 point) {
        const auto pixel = pixelOf(view().pose(), view().lens(), point);
        return pixel ? QPointF(pixel->x, pixel->y) : QPointF(-1, -1);
    }
    void send(QEvent::Type type, QPointF pixel, Qt::MouseButton button, Qt::MouseButtons buttons,
              Qt::KeyboardModifiers keys) {
        QMouseEvent event(type, pixel, view().mapToGlobal(pixel), button, buttons, keys);
        QCoreApplication::sendEvent(&view(), &event);
    }
    void click(glm::dvec3 point, Qt::KeyboardModifiers keys = {}) {
        send(QEvent::MouseButtonPress, pixelAt(point), Qt::LeftButton, Qt::LeftButton, keys);
        send(QEvent::MouseButtonRelease, pixelAt(point), Qt::LeftButton, Qt::NoButton, keys);
    }
    void drag(glm::dvec3 from, glm::dvec3 to, Qt::KeyboardModifiers keys) {
        send(QEvent::MouseButtonPress, pixelAt(from), Qt::LeftButton, Qt::LeftButton, keys);
        send(QEvent::MouseMove, pixelAt((from + to) / 2.0), Qt::NoButton, Qt::LeftButton, keys);
        send(QEvent::MouseMove, pixelAt(to), Qt::NoButton, Qt::LeftButton, keys);
        send(QEvent::MouseButtonRelease, pixelAt(to), Qt::LeftButton, Qt::NoButton, keys);
    }
    QString facts() {
        for (const QLabel* label : window->tools().dock()->findChildren<QLabel*>())
            if (label->text().contains(QStringLiteral("<table>"))) return label->text();
        return {};
    }
};

const glm::dvec3 southRoof{0, -40, 60}, lowRoof{75, 35, 25}, towerRoof{-87, 42, 90};

TEST_F(GroupWindow, ClicksWithCtrlAddAndRemove) {
    click(southRoof);
    EXPECT_THAT(building().all(), ElementsAre(0));
    click(towerRoof, Qt::ControlModifier);
    EXPECT_THAT(building().all(), ElementsAre(0, 2));
    EXPECT_FALSE(building().selected()) << "tools for one building have none";
    EXPECT_EQ(building().id(), "");
    click({20, 30, 0}, Qt::ControlModifier);
    EXPECT_THAT(building().all(), ElementsAre(0, 2)) << "a miss does not lose the selection";
    click(southRoof, Qt::ControlModifier);
    EXPECT_THAT(building().all(), ElementsAre(2));
    EXPECT_EQ(building().selected(), 2U) << "one is left, as if it had been clicked";
    click(lowRoof);
    EXPECT_THAT(building().all(), ElementsAre(1));
}

TEST_F(GroupWindow, ADragWithCtrlAndShiftSelectsWhatLiesInIt) {
    const CameraPose before = view().pose();
    drag({-120, -90, 0}, {40, 90, 0}, boxKeys);
    EXPECT_THAT(building().all(), ElementsAre(0, 2)) << "not the Low House";
    EXPECT_EQ(view().pose(), before) << "the camera stays";
    drag({120, 90, 0}, {-120, -90, 0}, boxKeys);
    EXPECT_THAT(building().all(), ElementsAre(0, 1, 2)) << "from any corner";
    drag({0, 60, 0}, {30, 80, 0}, boxKeys);
    EXPECT_THAT(building().all(), IsEmpty());
    click(towerRoof);
    drag({-120, -90, 0}, {40, 90, 0}, Qt::ControlModifier);
    EXPECT_THAT(building().all(), ElementsAre(2)) << "a drag with Ctrl turns the sun";
}

TEST_F(GroupWindow, TheSectionBoxLimitsTheRectangle) {
    window->panel().section().set(SectionBox{{-150, -100, -1}, {-50, 100, 100}});
    drag({-120, -90, 0}, {120, 90, 0}, boxKeys);
    EXPECT_THAT(building().all(), ElementsAre(2));
}

TEST_F(GroupWindow, TheDockStatesNumberAndFloorArea) {
    building().selectAll({0, 1});
    const double area = collectFacts(*city().buildings[0], city()).grossFloorM2.value_or(0) +
                        collectFacts(*city().buildings[1], city()).grossFloorM2.value_or(0);
    EXPECT_GT(area, 10000);
    EXPECT_THAT(facts().toStdString(), HasSubstr("2 buildings selected"));
    EXPECT_THAT(facts().toStdString(), HasSubstr(describeSmallArea(area).toStdString()));
    const auto* all = window->tools().dock()->findChild<QPushButton*>(QStringLiteral("demolishAll"));
    EXPECT_TRUE(all->isVisibleTo(window->tools().dock()));
    building().select(0);
    EXPECT_FALSE(all->isVisibleTo(window->tools().dock()));
}

TEST(GroupFacts, StateWhatIsNotCounted) {
    City city = test::smallCity();
    Building kiosk = *city.buildings[1];
    kiosk.parts[0].topM = 1;
    city.buildings.push_back(std::make_shared<const Building>(kiosk));
    const std::vector<std::uint32_t> both{0, 3};
    const GroupFacts facts = collectFacts(both, city);
    EXPECT_EQ(facts.buildings, 2U);
    EXPECT_EQ(facts.unmeasured, 1U) << "it is lower than a storey";
    EXPECT_EQ(facts.grossFloorM2, collectFacts(*city.buildings[0], city).grossFloorM2);
}

TEST_F(GroupWindow, DeleteDemolishesAllAsOneStep) {
    building().selectAll({0, 2});
    const std::vector<QAction*> tools = window->tools().actions();
    const auto demolish = std::ranges::find(tools, QKeySequence(Qt::Key_Delete), &QAction::shortcut);
    ASSERT_NE(demolish, tools.end());
    EXPECT_TRUE((*demolish)->isEnabled());
    (*demolish)->trigger();
    ASSERT_TRUE(waitFor([this] { return city().buildings.size() == 1; }));
    EXPECT_EQ(city().buildings[0]->name, "Low House");
    EXPECT_THAT(building().all(), IsEmpty());
    EXPECT_FALSE((*demolish)->isEnabled());
    workbench().document().undoStack().undo();
    EXPECT_TRUE(waitFor([this] { return city().buildings.size() == 3; })) << "one step of undo";
}

TEST_F(GroupWindow, EscEndsTheSelectionAndACityKeepsIt) {
    building().selectAll({0, 2});
    build();
    ASSERT_EQ(building().all().size(), 2U) << "by their ids, in the scenario with a tower";
    EXPECT_EQ(city().buildings[building().all()[1]]->name, "Tower");
    Q_EMIT window->panel().navigator().keyPressed(Qt::Key_Escape);
    EXPECT_THAT(building().all(), IsEmpty());
}

}  // namespace
}  // namespace noonmark
