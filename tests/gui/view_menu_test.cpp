#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/window/time/sun_at_moment.h"
#include "app/window/view/view_presets.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;
using test::waitFor;

QStringList entriesOf(const QMenu& menu) {
    QStringList texts;
    for (const QAction* action : menu.actions()) texts << action->text();
    return texts;
}

TEST(ViewPresets, LookTowardsTheOppositeOfWhereTheyStand) {
    const CameraPose pose{{10, 20, 3}, 500, 33, 45};
    const CameraPose south = lookFromSide(pose, 180);
    EXPECT_EQ(south.headingDeg, 0) << "from the south, north is ahead";
    EXPECT_EQ(lookFromSide(pose, 270).headingDeg, 90);
    EXPECT_LT(south.pitchDeg, 15);
    EXPECT_EQ(south.target, pose.target);
    EXPECT_EQ(south.distanceM, pose.distanceM);
}

TEST(ViewPresets, TheSunsViewIsAlongItsRays) {
    SunAtMoment sun;
    sun.azimuthDeg = 150;
    sun.altitudeDeg = 40;
    const CameraPose seen = lookFromSun({}, sun);
    EXPECT_EQ(seen.headingDeg, 330);
    EXPECT_EQ(seen.pitchDeg, 40);
    // From eye to ground is away from the sun.
    const double azimuth = 150 * M_PI / 180, altitude = 40 * M_PI / 180;
    const glm::dvec3 towards{std::cos(altitude) * std::sin(azimuth), std::cos(altitude) * std::cos(azimuth),
                             std::sin(altitude)};
    EXPECT_NEAR(glm::dot(computeForward(seen), towards), -1, 1e-9);
}

TEST_F(ProjectWindow, TheMenuOfTheViewIsAboutWhatIsUnderTheCursor) {
    Project next = session().project();
    next.places.push_back({"Meadow", PlaceKind::park, {test::square({-60, -60}, 120)}});
    ASSERT_TRUE(session().change(next, QStringLiteral("place")));
    CityView& view = window->panel().view();
    view.setPose({{0, 0, 0}, 60, 0, 90});
    const QPointF middle(view.width() / 2.0, view.height() / 2.0);
    const auto pick = window->panel().navigator().pickAt(middle);
    ASSERT_TRUE(pick);
    const QStringList entries = entriesOf(*window->context().makeMenu(middle));
    EXPECT_EQ(entries.contains(QStringLiteral("Demolish")), pick->building.has_value());
    EXPECT_EQ(entries.contains(QStringLiteral("Meadow")), !pick->building.has_value());
    EXPECT_TRUE(entries.contains(QStringLiteral("Draw lot")));
}

TEST_F(ProjectWindow, TheMenuOfABuildingSelectsIt) {
    // Building 1 is the Low House: looked at from above, it is in the middle of the view.
    const Building& house = *workbench().city()->city().buildings[1];
    const Box2 box = bounds(house);
    const glm::dvec2 middle = glm::dvec2(box.low + box.high) / 2.0;
    CityView& view = window->panel().view();
    view.setPose({{middle.x, middle.y, 0}, 200, 0, 90});
    const auto menu = window->context().makeMenu({view.width() / 2.0, view.height() / 2.0});
    ASSERT_TRUE(entriesOf(*menu).contains(QStringLiteral("Demolish")));
    for (QAction* action : menu->actions())
        if (action->text() == QStringLiteral("Select")) action->trigger();
    EXPECT_EQ(window->tools().building().selected(), 1U);
    for (QAction* action : menu->actions())
        if (action->text() == QStringLiteral("Study its surroundings")) action->trigger();
    const Box2 region = bounds(workbench().document().settings().region);
    EXPECT_LT(region.low.x, box.low.x - 49);
    EXPECT_GT(region.high.y, box.high.y + 49);
}

}  // namespace
}  // namespace noonmark
