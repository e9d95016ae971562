#include "app/gui/view/panel/polygon_drawing.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>
#include <glm/geometric.hpp>

#include "app/gui/base/looks/units.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/small_open_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

/// A lot is being drawn in the view of the small city, seen from above.
struct PolygonDrawingTest : ::testing::Test {
    ViewPanel panel;
    std::vector<Footprint> pieces;

    void SetUp() override {
        panel.resize(900, 700);
        panel.show();
        panel.showCity(test::smallOpenCity());
        panel.navigator().show({{-200, -200}, {200, 200}});
        QObject::connect(&panel.lotTool(), &PolygonTool::finished,
                         [this](const std::vector<Footprint>& made) { pieces = made; });
        panel.lotTool().begin();
    }
    void TearDown() override { QTest::keyRelease(&panel.view(), Qt::Key_Control); }

    [[nodiscard]] QPointF pixelAt(glm::dvec2 ground, glm::dvec2 besidePx = {0, 0}) {
        const auto pixel = pixelOf(panel.view().pose(), panel.view().lens(), {ground, 0});
        return {pixel->x + besidePx.x, pixel->y + besidePx.y};
    }
    void click(QPointF pixel) { Q_EMIT panel.navigator().clicked(pixel); }
    void hover(QPointF pixel) { Q_EMIT panel.navigator().hovered(pixel); }
    void press(int key) { Q_EMIT panel.navigator().keyPressed(key); }
    void type(const char* keys) {
        for (const char* key = keys; *key != '\0'; ++key) press(QChar(*key).toUpper().unicode());
    }
    [[nodiscard]] const std::vector<glm::vec3>& points() { return panel.lotTool().points(); }
    [[nodiscard]] glm::dvec2 last() { return glm::dvec2(points().back()); }
    [[nodiscard]] QString label() {
        return panel.cursorLabel().isVisible() ? panel.cursorLabel().text() : QString();
    }
    [[nodiscard]] const std::optional<PointMarks::Mark>& mark() { return panel.view().pointMarks().snap(); }
};

TEST_F(PolygonDrawingTest, AClickNearACornerTakesTheCorner) {
    hover(pixelAt({20, -20}, {6, -6}));
    ASSERT_TRUE(mark());
    EXPECT_EQ(mark()->shape, PointMarks::Shape::snappedCorner);
    EXPECT_EQ(label(), QStringLiteral("corner"));
    click(pixelAt({20, -20}, {6, -6}));
    ASSERT_EQ(points().size(), 1U);
    EXPECT_EQ(last(), glm::dvec2(20, -20));
    hover(pixelAt({20, -45}, {5, 0}));
    EXPECT_EQ(label(), QStringLiteral("25.0 m\nedge"));
    click(pixelAt({20, -45}, {5, 0}));
    EXPECT_NEAR(last().x, 20, 1e-5);
    EXPECT_NEAR(last().y, -45, 0.01);
    click(pixelAt({20, -20}, {14, 0}));
    EXPECT_GT(last().x, 20.5) << "14 pixels are beyond reach";
}

TEST_F(PolygonDrawingTest, WithCtrlPointsStayWhereTheyAre) {
    QTest::keyPress(&panel.view(), Qt::Key_Control, Qt::ControlModifier);
    click(pixelAt({20, -20}, {6, 0}));
    ASSERT_EQ(points().size(), 1U);
    EXPECT_GT(last().x, 20.5);
    EXPECT_FALSE(mark());
}

TEST_F(PolygonDrawingTest, AClickOnTheFirstCornerClosesTheOutline) {
    for (const glm::dvec2 corner : {glm::dvec2{100, 100}, {140, 100}, {140, 130}}) click(pixelAt(corner));
    const glm::dvec2 first(points().front());
    hover(pixelAt(first, {4, 4}));
    EXPECT_TRUE(label().endsWith(QStringLiteral("first corner: closes the outline")))
        << label().toStdString();
    click(pixelAt(first, {4, 4}));
    EXPECT_TRUE(panel.lotTool().active()) << "others still see the click as one of the drawing";
    ASSERT_TRUE(test::waitFor([this] { return !pieces.empty(); }));
    EXPECT_NEAR(area(pieces.front()), 600, 10);
    EXPECT_FALSE(mark());
}

TEST_F(PolygonDrawingTest, ATypedLengthPlacesTheNextCornerTowardsTheCursor) {
    panel.lotTool().addPoint({100, 100, 0});
    panel.lotTool().moveTo({103, 104, 0});
    type("40 m");
    EXPECT_EQ(points().size(), 1U) << "not entered yet";
    press(Qt::Key_Return);
    ASSERT_EQ(points().size(), 2U);
    EXPECT_NEAR(last().x, 124, 1e-4);
    EXPECT_NEAR(last().y, 132, 1e-4);
    panel.lotTool().moveTo({0, 132, 0});
    type("131' 3\"");
    press(Qt::Key_Enter);
    ASSERT_EQ(points().size(), 3U);
    EXPECT_NEAR(last().x, 124 - 131.25 * 0.3048, 1e-4);
    EXPECT_NEAR(last().y, 132, 1e-4);
}

TEST_F(PolygonDrawingTest, ANumberAloneIsInTheUnitsInUse) {
    applyUnits(UnitSystem::imperial);
    panel.lotTool().addPoint({100, 100, 0});
    panel.lotTool().moveTo({150, 100, 0});
    type("100");
    EXPECT_EQ(label(), QStringLiteral("Length: 100 ft  (Enter)"));
    press(Qt::Key_Return);
    applyUnits(UnitSystem::metric);
    EXPECT_NEAR(last().x, 130.48, 1e-4);
}

TEST_F(PolygonDrawingTest, AnAzimuthIsClockwiseFromNorthAndNeedsNoCursor) {
    panel.lotTool().addPoint({100, 100, 0});
    type("40<30");
    EXPECT_EQ(label(), QStringLiteral("Length: 40 m, azimuth: 30° clockwise from north  (Enter)"));
    press(Qt::Key_Return);
    ASSERT_EQ(points().size(), 2U);
    EXPECT_NEAR(last().x, 120, 1e-4);
    EXPECT_NEAR(last().y, 100 + 40 * 0.8660254, 1e-4);
}

TEST_F(PolygonDrawingTest, BackspaceAndEscEditTheTextFirst) {
    panel.lotTool().addPoint({100, 100, 0});
    panel.lotTool().addPoint({140, 100, 0});
    type("12");
    press(Qt::Key_Backspace);
    EXPECT_EQ(label(), QStringLiteral("Length: 1 m  (Enter)"));
    press(Qt::Key_Escape);
    EXPECT_TRUE(panel.lotTool().active());
    EXPECT_EQ(points().size(), 2U);
    press(Qt::Key_Backspace);
    EXPECT_EQ(points().size(), 1U);
    press(Qt::Key_Escape);
    EXPECT_FALSE(panel.lotTool().active());
}

TEST_F(PolygonDrawingTest, WhatIsNoLengthOrHasNoDirectionIsRefused) {
    panel.lotTool().addPoint({100, 100, 0});
    type("40");
    press(Qt::Key_Return);
    EXPECT_EQ(points().size(), 1U);
    EXPECT_TRUE(panel.messages().text().contains(QStringLiteral("direction"))) << "the cursor was nowhere";
    type("4 0 ft");
    press(Qt::Key_Return);
    EXPECT_EQ(points().size(), 1U);
    EXPECT_TRUE(panel.messages().text().contains(QStringLiteral("not a length")));
}

TEST_F(PolygonDrawingTest, LettersOfATypedLengthAreNoShortcuts) {
    panel.lotTool().addPoint({100, 100, 0});
    const auto isClaimed = [this](int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QKeyEvent override(QEvent::ShortcutOverride, key, modifiers);
        override.ignore();
        QCoreApplication::sendEvent(&panel.view(), &override);
        return override.isAccepted();
    };
    EXPECT_FALSE(isClaimed(Qt::Key_M));
    type("40");
    EXPECT_TRUE(isClaimed(Qt::Key_M));
    EXPECT_TRUE(isClaimed(Qt::Key_Period));
    EXPECT_FALSE(isClaimed(Qt::Key_M, Qt::ControlModifier));
    press(Qt::Key_Escape);
    EXPECT_FALSE(isClaimed(Qt::Key_M));
}

}  // namespace
}  // namespace noonmark
