#include <QPushButton>
#include <QTest>
#include <glm/geometric.hpp>

#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

using test::waitFor;
using RegionInSight = test::AnswersWindow;

TEST_F(RegionInSight, AStudyOutOfSightIsGoneTo) {
    const Box2 box = bounds(workbench().document().settings().region);
    const glm::dvec2 middle = glm::dvec2(box.low + box.high) * 0.5;
    CityView& view = window->panel().view();
    window->panel().navigator().show({box.high + glm::vec2(100), box.high + glm::vec2(160)});
    ASSERT_GT(glm::distance(glm::dvec2(view.pose().target), middle), 60);
    QTest::mouseClick(window->findChild<QPushButton*>(QStringLiteral("run")), Qt::LeftButton);
    EXPECT_LT(glm::distance(glm::dvec2(view.pose().target), middle), 5);
    ASSERT_TRUE(waitFor([this] { return workbench().study() != nullptr; }));
}

TEST_F(RegionInSight, AStudyInSightLeavesTheCameraAlone) {
    const Box2 box = bounds(workbench().document().settings().region);
    window->panel().navigator().show({box.low - glm::vec2(50), box.high + glm::vec2(10)});
    const CameraPose before = window->panel().view().pose();
    QTest::mouseClick(window->findChild<QPushButton*>(QStringLiteral("run")), Qt::LeftButton);
    EXPECT_EQ(window->panel().view().pose().target, before.target);
}

}  // namespace
}  // namespace noonmark
