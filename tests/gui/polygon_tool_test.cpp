#include "app/gui/view/panel/polygon_tool.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/gui/session/study/region_words.h"
#include "app/gui/view/panel/ground_lines.h"

namespace noonmark {
namespace {

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
