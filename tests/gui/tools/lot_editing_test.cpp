#include "app/gui/tools/editing/lot_editing.h"

#include <gtest/gtest.h>

#include <QUndoStack>
#include <glm/geometric.hpp>

#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/tools/massing/massing_panel.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::waitFor;

/// The window with a project whose lot "Yard" is the square from (20, 20) to (50, 50), seen from above. Low
/// House stands from (60, 20) to (90, 50).
struct LotEditingTest : test::ProjectWindow {
    void SetUp() override {
        ProjectWindow::SetUp();
        panel().navigator().show({{-60, -60}, {120, 120}});
        window->tools().editLot(yard());
    }
    ViewPanel& panel() { return window->panel(); }
    LotEditing& editing() { return window->tools().lotEditing(); }
    QUndoStack& undoStack() { return workbench().document().undoStack(); }
    NamedLot yard() { return findLot(session().project(), "Yard").value(); }
    [[nodiscard]] QPointF pixelAt(glm::dvec2 ground) {
        const auto pixel = pixelOf(panel().view().pose(), panel().view().lens(), {ground, 0});
        return {pixel->x, pixel->y};
    }
    void drag(glm::dvec2 from, glm::dvec2 to) {
        ASSERT_TRUE(editing().grab(pixelAt(from)));
        editing().dragTo(pixelAt(to));
        editing().drop();
    }
    void click(glm::dvec2 at) {
        ASSERT_TRUE(editing().grab(pixelAt(at)));
        editing().drop();
    }
    void press(int key) { Q_EMIT panel().navigator().keyPressed(key); }
};

const Ring square{{20, 20}, {50, 20}, {50, 50}, {20, 50}};

TEST_F(LotEditingTest, ADraggedCornerIsOneStepThatCanBeUndone) {
    const int steps = undoStack().index();
    drag({20, 20}, {5, 8});
    EXPECT_EQ(undoStack().index(), steps + 1);
    EXPECT_NEAR(glm::distance(yard().outline.outer[0], glm::vec2(5, 8)), 0, 0.01);
    EXPECT_EQ(yard().outline.outer[2], glm::vec2(50, 50));
    EXPECT_EQ(editing().lot()->outline, yard().outline);
    undoStack().undo();
    EXPECT_EQ(yard().outline.outer, square);
    EXPECT_EQ(editing().lot()->outline.outer, square) << "its handles follow";
    undoStack().redo();
    EXPECT_NE(yard().outline.outer, square);
    EXPECT_TRUE(editing().active());
}

TEST_F(LotEditingTest, ADraggedCornerSnapsToAHouse) {
    drag({50, 50}, {60.6, 49.5});
    EXPECT_EQ(yard().outline.outer[2], glm::vec2(60, 50));
}

TEST_F(LotEditingTest, ADraggedSideStaysParallelAndEndsWhereItSnaps) {
    drag({50, 30}, {60.4, 36});
    EXPECT_EQ(bounds(yard().outline), (Box2{{20, 20}, {60, 50}}))
        << "its line is that of the building's wall";
    drag({30, 50}, {33, 70});
    const Box2 box = bounds(yard().outline);
    EXPECT_NEAR(double(box.high.y), 70, 0.01);
    EXPECT_EQ(box.high.x, 60);
    EXPECT_NEAR(area(yard().outline), 40 * 50, 1);
}

TEST_F(LotEditingTest, AClickOnAMiddleAddsACornerAndDeleteRemovesIt) {
    click({35, 20});
    ASSERT_EQ(yard().outline.outer.size(), 5U);
    EXPECT_EQ(yard().outline.outer[1], glm::vec2(35, 20));
    click({35, 20});
    EXPECT_EQ(editing().selectedCorner(), 1U);
    press(Qt::Key_Delete);
    EXPECT_EQ(yard().outline.outer, square);
    EXPECT_FALSE(editing().selectedCorner());
}

TEST_F(LotEditingTest, ThreeCornersRemain) {
    click({50, 50});
    press(Qt::Key_Delete);
    ASSERT_EQ(yard().outline.outer.size(), 3U);
    click({20, 20});
    const int steps = undoStack().index();
    press(Qt::Key_Delete);
    EXPECT_EQ(yard().outline.outer.size(), 3U);
    EXPECT_EQ(undoStack().index(), steps);
    EXPECT_TRUE(message().contains(QStringLiteral("three corners"))) << message().toStdString();
}

TEST_F(LotEditingTest, SidesThatWouldCrossAreRefusedAndNothingChanges) {
    const int steps = undoStack().index();
    drag({50, 50}, {35, 10});
    EXPECT_EQ(undoStack().index(), steps);
    EXPECT_EQ(yard().outline.outer, square);
    EXPECT_EQ(editing().lot()->outline.outer, square);
    EXPECT_TRUE(message().contains(QStringLiteral("would cross"))) << message().toStdString();
}

TEST_F(LotEditingTest, EscTakesADragBackAndThenEndsTheTool) {
    ASSERT_TRUE(editing().grab(pixelAt({20, 20})));
    editing().dragTo(pixelAt({0, 0}));
    ASSERT_TRUE(waitFor([this] { return editing().lot()->outline.outer != square; }));
    press(Qt::Key_Escape);
    EXPECT_EQ(editing().lot()->outline.outer, square);
    editing().drop();
    EXPECT_EQ(yard().outline.outer, square);
    EXPECT_FALSE(panel().view().pointMarks().shown().empty());
    press(Qt::Key_Escape);
    EXPECT_FALSE(editing().active());
    EXPECT_TRUE(panel().view().pointMarks().shown().empty());
    EXPECT_FALSE(editing().grab(pixelAt({20, 20})));
}

TEST_F(LotEditingTest, OtherToolsAndALostLotEndIt) {
    window->tools().building().select(0);
    EXPECT_FALSE(editing().active());
    window->tools().editLot(yard());
    EXPECT_TRUE(window->tools().building().all().empty()) << "Delete belongs to the corner";
    panel().regionTool().begin();
    EXPECT_FALSE(editing().active());
    window->tools().editLot(yard());
    EXPECT_FALSE(panel().regionTool().active());
    ASSERT_TRUE(session().rename(ProjectPart::lot, "Yard", "Garden"));
    EXPECT_FALSE(editing().active());
}

}  // namespace
}  // namespace noonmark
