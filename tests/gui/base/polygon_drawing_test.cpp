#include <gtest/gtest.h>
#include <QLabel>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/gui/base/looks/units.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/view/panel/ground_layers.h"
#include "app/gui/view/panel/polygon_drawing.h"
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

struct Drawing {
    PolygonTool tool{QStringLiteral("region")};
    std::optional<std::vector<Footprint>> pieces;
    int refusals = 0;

    Drawing() {
        QObject::connect(&tool, &PolygonTool::finished,
                         [this](const std::vector<Footprint>& made) { pieces = made; });
        QObject::connect(&tool, &PolygonTool::refused, [this] { ++refusals; });
        tool.begin();
    }
    void click(std::initializer_list<glm::dvec2> points) {
        for (const glm::dvec2 point : points) tool.addPoint({point, 0});
    }
    [[nodiscard]] double areaM2() const {
        double sum = 0;
        for (const Footprint& polygon : *pieces) sum += area(polygon);
        return sum;
    }
};

TEST(PolygonTool, ClicksMakeAPolygonInAnyDirection) {
    Drawing drawing;
    drawing.click({{0, 0}, {0, 10}, {20, 10}, {20, 0}});
    drawing.tool.finish();
    ASSERT_TRUE(drawing.pieces);
    EXPECT_NEAR(drawing.areaM2(), 200, 1e-3);
    EXPECT_FALSE(drawing.tool.active());
}

TEST(PolygonTool, ADoubleClickIsNoCornerTwice) {
    Drawing drawing;
    drawing.click({{0, 0}, {10, 0}, {10, 10}, {10, 10.01}});
    EXPECT_EQ(drawing.tool.line().size(), 3U);
}

TEST(PolygonTool, TwoCornersAreRefusedAndMayBeContinued) {
    Drawing drawing;
    drawing.click({{0, 0}, {10, 0}});
    drawing.tool.finish();
    EXPECT_EQ(drawing.refusals, 1);
    EXPECT_TRUE(drawing.tool.active());
    drawing.click({{5, 8}});
    drawing.tool.finish();
    EXPECT_TRUE(drawing.pieces);
}

TEST(PolygonTool, CornersInALineAreRefused) {
    Drawing drawing;
    drawing.click({{0, 0}, {10, 0}, {20, 0}});
    drawing.tool.finish();
    EXPECT_EQ(drawing.refusals, 1);
    EXPECT_FALSE(drawing.pieces);
}

TEST(PolygonTool, ABowTieBecomesTwoPieces) {
    Drawing drawing;
    drawing.click({{0, 0}, {10, 10}, {10, 0}, {0, 10}});
    drawing.tool.finish();
    ASSERT_TRUE(drawing.pieces);
    EXPECT_EQ(drawing.pieces->size(), 2U);
    EXPECT_NEAR(drawing.areaM2(), 50, 0.1);
}

TEST(PolygonTool, CancelAndBackspace) {
    Drawing drawing;
    drawing.click({{0, 0}, {10, 0}, {10, 10}});
    drawing.tool.removeLastPoint();
    EXPECT_EQ(drawing.tool.line().size(), 2U);
    drawing.tool.cancel();
    EXPECT_FALSE(drawing.tool.active());
    drawing.tool.finish();
    EXPECT_FALSE(drawing.pieces);
    EXPECT_EQ(drawing.refusals, 0);
}

TEST(PolygonTool, TheLineFollowsTheCursor) {
    Drawing drawing;
    drawing.tool.moveTo({5, 5, 0});
    EXPECT_TRUE(drawing.tool.line().empty());
    drawing.click({{0, 0}});
    drawing.tool.moveTo({5, 5, 0});
    ASSERT_EQ(drawing.tool.line().size(), 2U);
    EXPECT_EQ(drawing.tool.line().back(), glm::vec3(5, 5, 0));
}

TEST(PolygonTool, TheNextSideGoesOnSquareToTheLastOne) {
    Drawing drawing;
    drawing.click({{0, 0}});
    drawing.tool.addPoint({30, 4, 0}, true);
    EXPECT_EQ(drawing.tool.line().back(), glm::vec3(30, 0, 0)) << "along the compass";
    drawing.tool.addPoint({33, 25, 0}, true);
    EXPECT_EQ(drawing.tool.line().back(), glm::vec3(30, 25, 0));
    drawing.tool.addPoint({20, 35, 0});
    drawing.tool.moveTo({12, 25, 0}, true);  // the previous side runs north-west
    const glm::vec3 corner = drawing.tool.line().back();
    EXPECT_NEAR(double(corner.x), 11, 1e-4);
    EXPECT_NEAR(double(corner.y), 26, 1e-4);
}

TEST(PolygonTool, MeasuresWhileItIsDrawn) {
    Drawing drawing;
    EXPECT_EQ(drawing.tool.sideM(), 0);
    drawing.click({{0, 0}, {30, 0}});
    EXPECT_NEAR(drawing.tool.sideM(), 30, 1e-6);
    EXPECT_EQ(drawing.tool.areaM2(), 0);
    drawing.tool.moveTo({30, 40, 0});
    EXPECT_NEAR(drawing.tool.sideM(), 40, 1e-6);
    EXPECT_NEAR(drawing.tool.areaM2(), 600, 1e-3);
}

TEST(VisibleGround, FromAboveItIsTheWindowsRectangle) {
    const ViewBounds city{{{-5000, -5000}, {5000, 5000}}, 100, 0};
    const ViewLens lens{40, 1200, 800};
    const double half = 1000 * std::tan(20 * std::numbers::pi / 180);
    const Box2 box = bounds(visibleGround({{100, 50, 0}, 1000, 0, 90}, lens, city));
    EXPECT_NEAR(double(box.high.y), 50 + half, 0.01);
    EXPECT_NEAR(double(box.low.x), 100 - 1.5 * half, 0.01);
}

TEST(VisibleGround, AboveTheHorizonItEndsAtTheCity) {
    const ViewBounds city{{{-500, -500}, {500, 500}}, 100, 0};
    const Region seen = visibleGround({{0, 0, 0}, 300, 20, 5}, {40, 1200, 800}, city);
    ASSERT_FALSE(seen.polygons.empty());
    const Box2 box = bounds(seen);
    EXPECT_GE(box.low.x, -500.01F);
    EXPECT_LE(box.high.y, 500.01F);
}

TEST(VisibleGround, LookingAwayThereIsNone) {
    const ViewBounds city{{{-500, -500}, {500, 500}}, 100, 0};
    EXPECT_TRUE(visibleGround({{0, 3000, 0}, 300, 0, 30}, {40, 1200, 800}, city).polygons.empty());
}

TEST(RegionWords, SayAreaAndCells) {
    Region region = makeRegionFromLocalBox({{0, 0}, {590, 580}});
    region.name = "park";
    EXPECT_EQ(describeRegion(region, 2), QStringLiteral("Park\n590 m × 580 m, 34.2 ha, 85,550 cells"));
    EXPECT_EQ(describeRegion({}, 2), QStringLiteral("No region yet"));
}

}  // namespace

}  // namespace noonmark
