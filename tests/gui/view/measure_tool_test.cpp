#include "app/gui/view/panel/view_tools.h"

#include <gtest/gtest.h>

#include <QAction>

#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;

TEST(MeasureTools, MeasureTheLastSideTheWholeLineAndTheArea) {
    const LineMeasures side = measureLine({{0, 0, 10}, {30, 40, 130}});
    EXPECT_DOUBLE_EQ(side.sideM, 50);
    EXPECT_DOUBLE_EQ(side.riseM, 120);
    EXPECT_DOUBLE_EQ(side.slopeM, 130);
    EXPECT_DOUBLE_EQ(side.areaM2, 0);
    // A right triangle far from the origin: sides 30 and 40, area 600.
    const LineMeasures triangle = measureLine({{1e5, 2e5, 0}, {1e5 + 30, 2e5, 0}, {1e5 + 30, 2e5 + 40, 0}});
    EXPECT_DOUBLE_EQ(triangle.lengthM, 70);
    EXPECT_DOUBLE_EQ(triangle.areaM2, 600);
    EXPECT_DOUBLE_EQ(measureLine({{1, 2, 3}}).lengthM, 0);
}

TEST(MeasureTools, StateHeightsOnlyWhereThereAreAny) {
    EXPECT_EQ(describeMeasures(measureLine({{0, 0, 0}, {30, 40, 0}}), UnitSystem::metric),
              QStringLiteral("50.0 m"));
    EXPECT_EQ(describeMeasures(measureLine({{0, 0, 130}, {30, 40, 10}}), UnitSystem::metric),
              QStringLiteral("50.0 m, 120.0 m down (130.0 m in space)"));
    EXPECT_EQ(describeMeasures(measureLine({{0, 0, 0}, {3.048, 0, 0}}), UnitSystem::imperial),
              QStringLiteral("10.0 ft"));
    EXPECT_TRUE(describeMeasures({}, UnitSystem::metric).isEmpty());
}

TEST(MeasureTools, KeepOnePointOfADoubleClickAndForgetRemovedOnes) {
    MeasureTool tool;
    tool.addPoint({0, 0, 0});
    EXPECT_TRUE(tool.line().empty()) << "not begun";
    tool.begin();
    tool.addPoint({0, 0, 0});
    tool.addPoint({0, 0, 0.001});
    EXPECT_EQ(tool.line().size(), 1U);
    tool.moveTo({5, 0, 0});
    EXPECT_EQ(tool.line().size(), 2U);
    tool.addPoint({5, 0, 0});
    EXPECT_EQ(tool.line().size(), 2U) << "the cursor still lies on the last point";
    tool.removeLastPoint();
    tool.removeLastPoint();
    EXPECT_TRUE(tool.line().empty());
}

TEST_F(ProjectWindow, AHeightIsMeasuredFromTheGroundToARoof) {
    ViewPanel& panel = window->panel();
    const Building& house = *workbench().city()->city().buildings[1];
    const Box2 box = bounds(house);
    const glm::dvec3 roof{glm::dvec2(box.low + box.high) / 2.0, double(topM(house))};
    CameraPose pose{{roof.x, roof.y, 0}, 300, 0, 60};
    pose.projection = Projection::parallel;
    panel.view().setPose(pose);
    const auto at = [&](glm::dvec3 point) {
        const auto pixel = pixelOf(panel.view().pose(), panel.view().lens(), point);
        return QPointF(pixel->x, pixel->y);
    };
    const glm::dvec3 ground{roof.x, double(box.low.y) - 6, 0};
    window->camera().measure()->trigger();
    EXPECT_TRUE(panel.drawing());
    Q_EMIT panel.navigator().clicked(at(ground));
    Q_EMIT panel.navigator().clicked(at(roof));
    const auto line = panel.measureTool().line();
    ASSERT_EQ(line.size(), 2U);
    EXPECT_NEAR(measureLine(line).riseM, roof.z, 0.05);
    EXPECT_FALSE(window->tools().building().selected()) << "the clicks belong to the measuring";
    Q_EMIT panel.navigator().doubleClicked(at(roof));
    EXPECT_FALSE(panel.drawing());
    EXPECT_FALSE(window->camera().measure()->isChecked());
    EXPECT_TRUE(panel.messages().text().contains(QStringLiteral("m up")))
        << panel.messages().text().toStdString();
}

}  // namespace
}  // namespace noonmark
